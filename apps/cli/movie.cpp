#include "movie.h"

#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <vector>

#include "airlight/error.h"
#include "image/output_file.h"
#include "interrupt.h"

extern char** environ;

namespace airlight::cli {
namespace fs = std::filesystem;

bool is_movie(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  return ending == ".mp4" || ending == ".mov" || ending == ".mkv";
}

void require_ffmpeg(const std::string& path) {
  const char* const folders = std::getenv("PATH");
  std::istringstream list(folders ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return;
  throw WorkError(fmt::format(
      "{}: movies need the program ffmpeg, which is not in PATH (Debian: apt-get install ffmpeg); or write frames: -o "
      "frames_%04d.png",
      path));
}

void encode_movie(const std::string& path, const std::string& frames, int first, int count, double frames_per_second) {
  OutputFile file(path);
  // sRGB in, BT.709 out, said in the file; nothing in it depends on time or threads.
  const std::vector<std::string> words{"ffmpeg",
                                       "-nostdin",
                                       "-hide_banner",
                                       "-loglevel",
                                       "error",
                                       "-y",
                                       "-framerate",
                                       fmt::format("{}", frames_per_second),
                                       "-start_number",
                                       std::to_string(first),
                                       "-i",
                                       frames,
                                       "-frames:v",
                                       std::to_string(count),
                                       "-vf",
                                       "scale=out_color_matrix=bt709:out_range=tv",
                                       "-pix_fmt",
                                       "yuv420p",
                                       "-c:v",
                                       "libx264",
                                       "-crf",
                                       "18",
                                       "-colorspace",
                                       "bt709",
                                       "-color_primaries",
                                       "bt709",
                                       "-color_trc",
                                       "bt709",
                                       "-fflags",
                                       "+bitexact",
                                       "-flags:v",
                                       "+bitexact",
                                       "-movflags",
                                       "+faststart",
                                       "-f",
                                       path.ends_with(".mkv") ? "matroska" : path.substr(path.size() - 3),
                                       file.temporary()};
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  if (const int reason = posix_spawnp(&child, "ffmpeg", nullptr, nullptr, argv.data(), environ))
    throw WorkError(fmt::format("{}: ffmpeg cannot be started: {}", path, std::strerror(reason)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    if (interrupted()) kill(child, SIGTERM);
  check_interrupt();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw WorkError(fmt::format("{}: ffmpeg failed (what it said stands above)", path));
  file.commit();
}

}  // namespace airlight::cli
