// A file that appears whole or not at all.
#pragma once
#include <string>

namespace airlight {

/// Where to write so that `target` appears only when commit() is called. For a target that exists and is not a regular file
/// (a device, a pipe) commit() copies the bytes there; an error on closing counts.
class OutputFile {
 public:
  /// @throws InputError where the target's folder does not exist or may not be written, or the target is a folder.
  explicit OutputFile(std::string target);
  ~OutputFile();  ///< not committed: the temporary file is removed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& temporary() const { return temporary_; }  ///< keeps the target's ending
  void commit();  ///< @throws WorkError

  /// Removes the temporary files of all OutputFiles alive; for a signal handler's way out.
  static void remove_all();

 private:
  std::string target_, temporary_;
  bool direct_ = false, done_ = false;
};

}  // namespace airlight
