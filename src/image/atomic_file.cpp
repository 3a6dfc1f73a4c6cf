#include "image/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>

#include "image/image.hpp"
#include "image/system_error.hpp"

namespace trace {
namespace {

constexpr mode_t usual_mode = 0666;  // less the umask

[[noreturn]] void fail(int error) {
  if (error == ENOENT || error == ENOTDIR) throw ImageError("no such directory");
  throw ImageError(system_reason(error));
}

// The name by which the kernel knows an open file, even one without a name of its own.
std::string descriptor_name(int descriptor) {
  return fmt::format("/proc/self/fd/{}", descriptor);
}

// Calls `attempt` with hidden names in `directory` until one is not taken; it returns 0 or an errno value.
template <typename Attempt>
std::filesystem::path with_hidden_name(const std::filesystem::path& directory, Attempt attempt) {
  for (int number = 0;; ++number) {
    std::filesystem::path name = directory / fmt::format(".trace-{}-{}.tmp", getpid(), number);
    const int error = attempt(name);
    if (error == 0) return name;
    if (error != EEXIST || number == 9999) fail(error);
  }
}

// Follows symbolic links, except one that leads nowhere: that is replaced.
std::filesystem::path resolve(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, ignored);
  return ignored ? path : resolved;
}

std::filesystem::path directory_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

// Ctrl-C waits until the hidden name is gone (if this is the thread it comes to).
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t held;
    sigemptyset(&held);
    for (int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& target, Temporary temporary) : target_(resolve(target)) {
  struct stat status {};
  if (stat(target.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) fail(EISDIR);
    direct_ = !S_ISREG(status.st_mode);
    replaces_ = !direct_;
    if (direct_) {
      descriptor_ = open(target.c_str(), O_WRONLY | O_CLOEXEC);
      if (descriptor_ < 0) fail(errno);
      return;
    }
    if (faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
  } else if (errno != ENOENT) {
    fail(errno);
  }
  open_temporary(temporary);
  if (replaces_) fchmod(descriptor_, status.st_mode & 07777);  // a refusal is no reason to lose the picture
}

AtomicFile::~AtomicFile() {
  if (!hidden_.empty()) unlink(hidden_.c_str());
  if (descriptor_ >= 0) close(descriptor_);
}

void AtomicFile::open_temporary(Temporary temporary) {
  const std::filesystem::path directory = directory_of(target_);
  if (temporary == Temporary::nameless && access("/proc/self/fd", X_OK) == 0) {
    descriptor_ = open(directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, usual_mode);
    if (descriptor_ >= 0) return;
    if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) fail(errno);  // else: none here
  }
  hidden_ = with_hidden_name(directory, [&](const std::filesystem::path& name) {
    descriptor_ = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, usual_mode);
    return descriptor_ >= 0 ? 0 : errno;
  });
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0)
      bytes = bytes.subspan(std::size_t(written));
    else if (errno != EINTR)
      fail(errno);
  }
}

void AtomicFile::link_hidden() {
  const std::string source = descriptor_name(descriptor_);
  hidden_ = with_hidden_name(directory_of(target_), [&](const std::filesystem::path& name) {
    return linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
  });
}

void AtomicFile::commit() {
  // Some file systems report a full disk only on closing; closing a duplicate tells while there is no name
  // yet.
  const int duplicate = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  if (duplicate < 0 || close(duplicate) != 0) fail(errno);
  if (direct_) return;

  const SignalsHeld held;
  // linkat makes a new name but never replaces one: if there is a file, even a very recent one, rename over
  // it.
  const bool linked = hidden_.empty() && !replaces_ &&
                      linkat(AT_FDCWD, descriptor_name(descriptor_).c_str(), AT_FDCWD, target_.c_str(),
                             AT_SYMLINK_FOLLOW) == 0;
  if (linked) return;
  if (hidden_.empty()) link_hidden();
  if (std::rename(hidden_.c_str(), target_.c_str()) != 0) fail(errno);
  hidden_.clear();
}

}  // namespace trace
