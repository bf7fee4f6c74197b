#include "image/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "airlight/error.h"

namespace airlight {
namespace fs = std::filesystem;

// remove_all() runs in a signal handler, where neither memory nor locks may be asked for: names lie in nodes that are
// reused and never freed, so the handler always walks valid memory.
struct OutputFile::Name {
  std::atomic<bool> taken = true, shown = false;
  char path[4096] = {};
  Name* next = nullptr;

  static inline std::atomic<Name*> all = nullptr;
};

namespace {

template <class Call>
auto retried(Call call) {  // a signal that the program handles is no failure
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

/// 0, or why the bytes could not be written; at: an offset, or -1 to append.
int write_whole(int file, std::string_view bytes, off_t at = -1) {
  while (!bytes.empty()) {
    const ssize_t n = retried([&] {
      return at < 0 ? ::write(file, bytes.data(), bytes.size()) : ::pwrite(file, bytes.data(), bytes.size(), at);
    });
    if (n < 0) return errno;
    if (n == 0) return EIO;
    bytes.remove_prefix(std::size_t(n));
    if (at >= 0) at += n;
  }
  return 0;
}

/// N of /dev/fd/N and /proc/self/fd/N, the descriptors that /dev/stdout and its like lead to. Opening such a name again
/// would start a redirected file from its beginning; the shell's own descriptor stands where it should.
std::optional<int> descriptor_of(const std::string& path) {
  for (const std::string_view start : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(start)) continue;
    int n = -1;
    const char* end = path.data() + path.size();
    const auto read = std::from_chars(path.data() + start.size(), end, n);
    if (read.ec == std::errc() && read.ptr == end && n >= 0) return n;
  }
  return {};
}

/// Where a name leads to.
struct Destination {
  std::string path;     // its links followed
  int descriptor = -1;  // an open one, in place of a path
  bool endless = false, exists = false;
  struct stat status {};

  explicit Destination(std::string name) : path(std::move(name)) {
    std::error_code error;
    for (int links = 0; !(descriptor = descriptor_of(path).value_or(-1), descriptor >= 0); ++links) {
      const fs::path link = fs::read_symlink(path, error);
      if (error) break;  // not a link
      endless = links == 40;
      if (endless) return;
      path = (fs::path(path).parent_path() / link).string();
    }
    exists = descriptor >= 0 ? ::fstat(descriptor, &status) == 0 : ::stat(path.c_str(), &status) == 0;
  }

  bool direct() const { return descriptor >= 0 || (exists && !S_ISREG(status.st_mode)); }
};

}  // namespace

bool OutputFile::is_direct(const std::string& target) { return Destination(target).direct(); }

OutputFile::OutputFile(std::string target, Unfinished unfinished)
    : target_(std::move(target)), keep_(unfinished == Unfinished::keep) {
  [[maybe_unused]] static const bool ignored = [] {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    return true;
  }();
  const auto refuse = [&](const std::string& why) { throw InputError("cannot write '" + target_ + "': " + why); };
  if (target_.empty()) refuse("the name is empty");

  const Destination destination(target_);
  destination_ = destination.path;
  descriptor_ = destination.descriptor;
  const bool exists = destination.exists;
  const auto mode = destination.status.st_mode;
  if (destination.endless) refuse("too many symbolic links");
  if (descriptor_ >= 0 && !exists) refuse("the descriptor is not open");
  if (exists && S_ISDIR(mode)) refuse("it is a folder");
  if (exists && descriptor_ < 0 && ::access(destination_.c_str(), W_OK) != 0) refuse(std::strerror(errno));
  direct_ = destination.direct();

  if (keep_ && direct_) {
    file_ = open_target();
    if (file_ < 0) refuse(std::strerror(errno));
    return;
  }
  std::error_code error;
  fs::path folder = direct_ ? fs::temp_directory_path(error) : fs::path(destination_).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, error)) refuse("the folder '" + folder.string() + "' does not exist");
  // The process number keeps programs apart, the count the files of one program, O_EXCL whatever else there may be
  // (another machine on the same disk). The name does not hold the target's, which may already be as long as a name can
  // be.
  static std::atomic<unsigned> count = 0;
  const std::string ending = fs::path(target_).extension().string();
  do {
    temporary_ =
        (folder / (".airlight-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp" + ending))
            .string();
    if (keep_) {
      // Made anew, never cut short: the one there may be what this program reads.
      temporary_ = destination_ + ".partial";
      ::unlink(temporary_.c_str());
    }
    file_ = retried(
        [&] { return ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, direct_ ? 0600 : 0666); });
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0) refuse("a file cannot be made in '" + folder.string() + "': " + std::strerror(errno));
  if (exists && !direct_) ::fchmod(file_, mode & 07777);  // as if it had been opened and overwritten
  if (keep_) return;

  for (name_ = Name::all; name_ && name_->taken.exchange(true); name_ = name_->next) {
  }
  if (!name_) {
    name_ = new Name;
    name_->next = Name::all;
    while (!Name::all.compare_exchange_weak(name_->next, name_)) {
    }
  }
  // A longer path is not removed on a signal, the one case left out.
  if (temporary_.size() < sizeof name_->path) {
    std::memcpy(name_->path, temporary_.c_str(), temporary_.size() + 1);
    name_->shown = true;
  }
}

OutputFile::~OutputFile() {
  if (file_ >= 0) ::close(file_);
  if (!done_ && !temporary_.empty() && kept().empty()) ::unlink(temporary_.c_str());
  if (!name_) return;
  name_->shown = false;
  name_->taken = false;
}

void OutputFile::fail(int reason) {
  const std::string rest = kept();
  if (rest.empty()) {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  } else if (file_ >= 0) {
    [[maybe_unused]] const int cut = ::ftruncate(file_, off_t(size_));  // to the last whole append
  }
  throw WorkError("writing '" + target_ + "' failed: " + std::strerror(reason) +
                  (rest.empty() ? "" : "; '" + rest + "' holds what was written before"));
}

void OutputFile::write(std::string_view bytes) {
  if (!(keep_ && direct_)) return write_at(size_, bytes);
  if (const int reason = write_whole(file_, bytes)) fail(reason);
}

void OutputFile::write_at(std::uint64_t offset, std::string_view bytes) {
  if (const int reason = write_whole(file_, bytes, off_t(offset))) fail(reason);
  size_ = std::max(size_, offset + bytes.size());
}

void OutputFile::commit() {
  if (keep_ && direct_) {
    if (::close(std::exchange(file_, -1)) != 0) fail(errno);
    done_ = true;
    return;
  }
  if (direct_) copy_to_target();
  // Some disks (network, quota) tell only here that the bytes did not fit; a rename before would show a broken file.
  else if (retried([&] { return ::fsync(file_); }) != 0 && errno != EINVAL)
    fail(errno);
  if (::close(std::exchange(file_, -1)) != 0) fail(errno);
  if (direct_ ? ::unlink(temporary_.c_str()) != 0 : ::rename(temporary_.c_str(), destination_.c_str()) != 0)
    fail(errno);
  done_ = true;
  if (name_) name_->shown = false;
}

int OutputFile::open_target() const {
  return retried(
      [&] { return descriptor_ >= 0 ? ::dup(descriptor_) : ::open(destination_.c_str(), O_WRONLY | O_CLOEXEC); });
}

void OutputFile::copy_to_target() {
  const int out = open_target();
  if (out < 0) fail(errno);
  int reason = 0;
  char block[1 << 16];
  for (off_t at = 0; reason == 0;) {
    const ssize_t n = retried([&] { return ::pread(file_, block, sizeof block, at); });
    if (n < 0) reason = errno;
    if (n <= 0) break;
    reason = write_whole(out, {block, std::size_t(n)});
    at += n;
  }
  if (::close(out) != 0 && reason == 0) reason = errno;
  if (reason) fail(reason);
}

void OutputFile::remove_all() {
  for (const Name* name = Name::all; name; name = name->next)
    if (name->shown) ::unlink(name->path);
}

}  // namespace airlight
