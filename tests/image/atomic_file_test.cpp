#include "image/atomic_file.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>

#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;
using Names = std::vector<std::string>;

namespace {

const Bytes old_bytes{'o', 'l', 'd'}, new_bytes{'n', 'e', 'w', '!'};

mode_t mode_of(const std::filesystem::path& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777;
}

// The superuser may write everywhere; while this lives, the program is somebody else.
class NotSuperuser {
 public:
  NotSuperuser() { REQUIRE((before_ != 0 || seteuid(65534) == 0)); }
  NotSuperuser(const NotSuperuser&) = delete;
  NotSuperuser& operator=(const NotSuperuser&) = delete;
  ~NotSuperuser() {
    if (seteuid(before_) != 0) std::abort();
  }

 private:
  uid_t before_ = geteuid();
};

}  // namespace

TEST_CASE("a committed file holds what was written, and nothing else is left") {
  const auto temporary = GENERATE(AtomicFile::Temporary::nameless, AtomicFile::Temporary::named);
  const bool replace = GENERATE(false, true);
  const TemporaryFolder directory;
  if (replace) put(directory / "file", old_bytes);
  {
    AtomicFile file(directory / "file", temporary);
    file.write(Bytes{'n', 'e'});
    file.write(Bytes{'w', '!'});
    file.commit();
  }
  CHECK(get(directory / "file") == new_bytes);
  CHECK(directory.names() == Names{"file"});
}

TEST_CASE("a file that was not committed leaves everything as it was") {
  const auto temporary = GENERATE(AtomicFile::Temporary::nameless, AtomicFile::Temporary::named);
  const TemporaryFolder directory;
  put(directory / "there", old_bytes);
  {
    AtomicFile there(directory / "there", temporary);
    AtomicFile missing(directory / "missing", temporary);
    there.write(new_bytes);
    missing.write(new_bytes);
    CHECK(get(directory / "there") == old_bytes);
    CHECK_FALSE(std::filesystem::exists(directory / "missing"));
  }
  CHECK(directory.names() == Names{"there"});
  CHECK(get(directory / "there") == old_bytes);
}

TEST_CASE("a program killed while it writes leaves neither half a file nor a temporary one") {
  const TemporaryFolder directory;
  const pid_t child = fork();
  if (child == 0) {
    AtomicFile file(directory / "file");
    file.write(new_bytes);
    raise(SIGKILL);
  }
  REQUIRE(child > 0);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK(directory.names().empty());
}

TEST_CASE("a file that appears while another is written under its name is replaced") {
  const TemporaryFolder directory;
  AtomicFile file(directory / "file");
  file.write(new_bytes);
  put(directory / "file", old_bytes);
  file.commit();
  CHECK(get(directory / "file") == new_bytes);
  CHECK(directory.names() == Names{"file"});
}

TEST_CASE("a new file gets the usual permissions, a replaced one keeps its own") {
  const auto temporary = GENERATE(AtomicFile::Temporary::nameless, AtomicFile::Temporary::named);
  const TemporaryFolder directory;
  put(directory / "there", old_bytes);
  REQUIRE(chmod((directory / "there").c_str(), 0640) == 0);
  const mode_t mask = umask(027);
  for (std::string_view name : {"there", "missing"}) AtomicFile(directory / name, temporary).commit();
  umask(mask);
  CHECK(mode_of(directory / "there") == 0640);
  CHECK(mode_of(directory / "missing") == 0640);
}

TEST_CASE("a symbolic link stays, the file it leads to is replaced") {
  const TemporaryFolder directory;
  put(directory / "file", old_bytes);
  std::filesystem::create_symlink("file", directory / "link");
  AtomicFile file(directory / "link");
  file.write(new_bytes);
  file.commit();
  CHECK(std::filesystem::is_symlink(directory / "link"));
  CHECK(get(directory / "file") == new_bytes);
}

TEST_CASE("a name in the working directory needs no directory before it") {
  const TemporaryFolder directory;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(directory.path());
  AtomicFile("file").commit();
  AtomicFile("file").commit();
  std::filesystem::current_path(before);
  CHECK(directory.names() == Names{"file"});
}

TEST_CASE("a file that cannot be written says why") {
  const TemporaryFolder directory;
  CHECK(reason([&] { AtomicFile file(directory.path()); }) == "is a directory");
  CHECK(reason([&] { AtomicFile file(directory / "none/file"); }) == "no such directory");
  put(directory / "file", old_bytes);
  CHECK(reason([&] { AtomicFile file(directory / "file/file"); }) == "no such directory");
}

TEST_CASE("a full disk is an error, and a device is not replaced") {
  const TemporaryFolder directory;
  std::filesystem::create_symlink("/dev/full", directory / "full.png");
  CHECK(reason([&] { write_image(directory / "full.png", colourful(8, 8)); }) == "no space left on device");
  CHECK(std::filesystem::is_character_file("/dev/full"));
  CHECK(directory.names() == Names{"full.png"});
}

TEST_CASE("a file or directory without permission to write is left alone") {
  const NotSuperuser nobody;
  const TemporaryFolder directory;
  put(directory / "file", old_bytes);
  REQUIRE(chmod((directory / "file").c_str(), 0444) == 0);
  CHECK(reason([&] { AtomicFile file(directory / "file"); }) == "permission denied");
  REQUIRE(chmod(directory.path().c_str(), 0555) == 0);
  CHECK(reason([&] { AtomicFile file(directory / "new"); }) == "permission denied");
  REQUIRE(chmod(directory.path().c_str(), 0755) == 0);
}
