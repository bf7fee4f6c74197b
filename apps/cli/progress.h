// A bar on the terminal for work that takes more than a second; nothing when standard error is not a terminal.
#pragma once
#include <chrono>
#include <string>

namespace airlight::cli {

class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();  ///< wipes the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param fraction  done so far, 0 .. 1; negative: unknown
  void show(double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  Clock::time_point started_ = Clock::now(), shown_ = started_;
  bool terminal_, visible_ = false;
};

}  // namespace airlight::cli
