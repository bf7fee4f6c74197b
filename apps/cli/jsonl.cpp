#include "jsonl.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "airlight/error.h"
#include "interrupt.h"
#include "progress.h"
#include "text_output.h"

namespace airlight::cli {

LineReader::LineReader(const std::string& path)
    : name_(path == "-" ? "standard input" : path),
      descriptor_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat about = {};
  if (descriptor_ < 0 || fstat(descriptor_, &about) != 0) {
    check_interrupt();
    throw InputError(fmt::format("{}: {}", name_, std::strerror(errno)));
  }
  if (S_ISDIR(about.st_mode)) throw InputError(name_ + ": a folder; expected a file of JSON lines");
  if (S_ISREG(about.st_mode)) size_ = static_cast<double>(about.st_size);
}

LineReader::~LineReader() {
  if (descriptor_ > STDIN_FILENO) close(descriptor_);
}

double LineReader::fraction() const { return size_ > 0 ? std::min(read_ / size_, 1.0) : -1; }

bool LineReader::fill() {
  buffer_.erase(0, std::exchange(position_, 0));
  const std::size_t before = buffer_.size();
  constexpr std::size_t block = 1 << 16;
  buffer_.resize(before + block);
  for (;;) {
    const ssize_t got = read(descriptor_, buffer_.data() + before, block);
    if (got < 0 && errno == EINTR) {
      check_interrupt();
      continue;
    }
    if (got < 0) throw WorkError(fmt::format("{}: {}", name_, std::strerror(errno)));
    buffer_.resize(before + static_cast<std::size_t>(got));
    read_ += static_cast<double>(got);
    return got > 0;
  }
}

bool LineReader::more_waits() const {
  if (buffer_.find('\n', position_) != buffer_.npos) return true;
  pollfd waiting{descriptor_, POLLIN, 0};
  return poll(&waiting, 1, 0) == 1;
}

std::vector<LineReader::Line> LineReader::next(std::size_t most) {
  constexpr std::size_t most_bytes = 16 << 20;
  std::vector<Line> lines;
  for (std::size_t bytes = 0; lines.size() < most && bytes < most_bytes;) {
    check_interrupt();
    if (!lines.empty() && !more_waits()) break;
    Line line{++lines_, {}, false};
    bool ended = false, any = false;
    while (!ended) {
      const std::size_t end = buffer_.find('\n', position_);
      ended = end != buffer_.npos;
      const std::size_t length = (ended ? end : buffer_.size()) - position_;
      any = any || ended || length > 0;
      const std::size_t room = longest - line.text.size();
      line.too_long = line.too_long || length > room;
      line.text.append(buffer_, position_, std::min(length, room));
      position_ += length + (ended ? 1 : 0);
      if (!ended && !fill()) break;
    }
    if (!any) break;
    if (line.text.find_first_not_of(" \t\r") == line.text.npos) continue;
    bytes += line.text.size();
    lines.push_back(std::move(line));
  }
  return lines;
}

void answer_lines(
    const std::string& input, const std::string& output, const std::string& what,
    const std::function<std::vector<std::string>(const std::string&, std::span<const LineReader::Line>)>& answer) {
  // Lines that are answered together save work; lines that take long are written soon, so that an interrupt loses
  // little.
  constexpr std::size_t most = 8192;
  constexpr std::chrono::duration<double> quick(0.2), slow(1);
  LineReader reader(input);
  TextOutput out(output, OutputFile::Unfinished::keep);
  Progress progress(what);
  std::size_t answered = 0;
  try {
    for (std::size_t chunk = 16;;) {
      const auto lines = reader.next(chunk);
      if (lines.empty()) break;
      const auto start = std::chrono::steady_clock::now();
      std::string text;
      for (const std::string& line : answer(reader.name(), lines)) text += line;
      out.write(text);
      answered += lines.size();
      progress.show(reader.fraction());
      const auto taken = std::chrono::steady_clock::now() - start;
      chunk = taken < quick ? std::min(4 * chunk, most) : taken > slow ? std::max<std::size_t>(chunk / 4, 1) : chunk;
    }
  } catch (const Interrupted&) {
    if (out.kept().empty()) throw;
    throw Interrupted(fmt::format("the first {} answers are in {}", answered, out.kept()));
  }
  out.finish();
}

}  // namespace airlight::cli
