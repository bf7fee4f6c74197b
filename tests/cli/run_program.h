// Runs the airlight command in a folder of its own and catches all that it says.
#pragma once
#include <sys/types.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../scratch_folder.h"

namespace airlight {

struct Outcome {
  int code = -1;  ///< exit code; 1000 + signal when killed
  std::string out, err;
};

struct Setting {
  std::string input = {};                     ///< standard input
  std::vector<std::string> environment = {};  ///< "NAME=value", added
  long file_size_limit = -1;                  ///< RLIMIT_FSIZE [bytes]; negative: none
};

/// The command at work, its current folder being `folder`.
class Program {
 public:
  Program(const Folder& folder, const std::vector<std::string>& arguments, const Setting& setting = {});
  ~Program();  ///< kills it when it still runs
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool running();
  void signal(int number);
  /// Waits for the end; kills after the seconds, which shows as code 1009.
  Outcome wait(double seconds = 60);

 private:
  pid_t process_;
  int status_ = -1;
  std::FILE *in_, *out_, *err_;
};

Outcome run(const Folder& folder, const std::vector<std::string>& arguments, const Setting& setting = {});

/// Runs it in one folder to its end; in another until a random moment of that time, when it is killed, then once more to its end. Files that
/// both leave must be alike.
void run_through_and_after_a_kill(const Folder& whole, const Folder& killed, const std::vector<std::string>& arguments);

/// One JSON value a line.
std::vector<nlohmann::json> json_lines(const std::string& text);

}  // namespace airlight
