// Lines in, lines out: the loop behind `probe --batch` and `eval`.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace airlight::cli {

/// Reads lines from a file descriptor without keeping more than a chunk, and notices Ctrl-C while it waits.
class LineReader {
 public:
  /// @param path  "-": standard input. @throws InputError when it cannot be opened.
  explicit LineReader(const std::string& path);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  struct Line {
    long number = 0;        ///< from 1
    std::string text;       ///< without its end; cut when too long
    bool too_long = false;  ///< more than `longest`
  };
  static constexpr std::size_t longest = 1 << 20;  ///< [bytes]

  /// The next lines that are not blank: at most `most` of them and about 16 MiB, fewer when whoever writes them pauses,
  /// so that a program on the other end of a pipe gets its answer. Empty at the end. @throws WorkError, Interrupted.
  std::vector<Line> next(std::size_t most);

  /// Share of the input that is read, 0 .. 1; negative where its size is unknown.
  double fraction() const;
  const std::string& name() const { return name_; }

 private:
  bool fill();  ///< false at the end
  bool more_waits() const;

  std::string name_;
  int descriptor_;
  std::string buffer_;
  std::size_t position_ = 0;
  long lines_ = 0;
  double size_ = 0, read_ = 0;
};

/// Answers every line: each chunk in turn goes through `answer`, which returns one line of output for each (its end
/// included). An output file is written as NAME.partial, whole lines only, and renamed at the end; after an interrupt
/// or a failure it stays under that name.
/// @param answer  must report bad lines in its answers
void answer_lines(
    const std::string& input, const std::string& output, const std::string& what,
    const std::function<std::vector<std::string>(const std::string& name, std::span<const LineReader::Line>)>& answer);

}  // namespace airlight::cli
