// A file that appears whole or not at all.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace airlight {

/// Where to write so that `target` appears only when commit() is called: a temporary file beside it, renamed at the
/// end.
///
/// Symbolic links are followed, so the file that they name is replaced and they stay. A target that exists and is not a
/// regular file (a device, a pipe), and a descriptor (/dev/stdout, /dev/fd/3), get the bytes copied by commit(); the
/// temporary file is then in the system's folder for such. Errors of the last flush and of closing count.
///
/// The first object made sets SIGXFSZ and SIGPIPE to be ignored in the whole process: a file-size limit and a reader
/// that went away are then errors with a message, and the temporary file is removed, where the default is to be killed.
class OutputFile {
 public:
  /// What becomes of a file that is never committed. `keep` is for long work of which the beginning is worth having:
  /// the temporary file is TARGET.partial, replaces an older one of that name, and outlives the program however it
  /// ends; a device, pipe or descriptor is written at once.
  enum class Unfinished { remove, keep };

  /// @throws InputError where the target's folder does not exist or may not be written, or the target is a folder.
  explicit OutputFile(std::string target, Unfinished unfinished = Unfinished::remove);
  ~OutputFile();  ///< not committed: the temporary file is removed unless it is to be kept and not empty
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& target() const { return target_; }
  /// The file that stays when commit() is never called; empty: none.
  std::string kept() const { return keep_ && !direct_ && size_ > 0 ? temporary_ : std::string(); }
  const std::string& temporary() const { return temporary_; }  ///< exists; keeps the target's ending

  /// The target is a device, a pipe or a descriptor: commit() copies.
  bool direct() const { return direct_; }
  /// What direct() would be, without touching anything.
  static bool is_direct(const std::string& target);

  /// Appends to the temporary file, for text and other streams; what is to be kept holds whole appends only. @throws
  /// WorkError naming the target and the reason.
  void write(std::string_view bytes);
  /// Writes at a place of the temporary file. @throws WorkError naming the target and the reason.
  void write_at(std::uint64_t offset, std::string_view bytes);

  void commit();  ///< @throws WorkError; the temporary file is removed and an existing target is as it was

  /// Removes the temporary files of all OutputFiles alive; may be called from a signal handler, on the way out.
  static void remove_all();

 private:
  [[noreturn]] void fail(int reason);
  int open_target() const;  ///< a device, pipe or descriptor
  void copy_to_target();

  struct Name;
  std::string target_, temporary_;
  std::string destination_;  ///< the target with its links followed
  Name* name_ = nullptr;     ///< what remove_all() knows of this file
  int file_ = -1;
  int descriptor_ = -1;  ///< the target is this open descriptor
  std::uint64_t size_ = 0;
  bool keep_, direct_ = false, done_ = false;
};

}  // namespace airlight
