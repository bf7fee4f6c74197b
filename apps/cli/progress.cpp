#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace airlight::cli {

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void Progress::show(double fraction) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!terminal_ || now - started_ < 1s || (visible_ && now - shown_ < 100ms)) return;
  shown_ = now;
  visible_ = true;
  const double seconds = std::chrono::duration<double>(now - started_).count();
  if (fraction < 0) {
    fmt::print(stderr, "\r{} {:.0f} s\033[K", what_, seconds);
  } else {
    constexpr int width = 30;
    const int filled = std::clamp(static_cast<int>(fraction * width), 0, width);
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %  {:.0f} s\033[K", what_, "", filled, "", width - filled,
               100 * fraction, seconds);
  }
  std::fflush(stderr);
}

}  // namespace airlight::cli
