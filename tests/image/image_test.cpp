// Which codec a file goes to, and the reasons a file cannot be read or written.
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <memory>

#include "image/bmp.hpp"
#include "image/png.hpp"
#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("what a picture file is, its content tells and not its name") {
  const TemporaryFolder directory;
  const Image image = colourful(6, 5);
  put(directory / "picture.bmp", encode_png(image));
  put(directory / "picture.png", encode_bmp(image));
  put(directory / "picture.jpg", encode_png(image));
  CHECK(read_image(directory / "picture.bmp").rgb == image.rgb);
  CHECK(read_image(directory / "picture.png").rgb == image.rgb);
  CHECK(read_image(directory / "picture.jpg").rgb == image.rgb);
}

TEST_CASE("a picture is written in the format its extension names, in either case") {
  const TemporaryFolder directory;
  const Image image = colourful(6, 5);
  write_image(directory / "a.png", image);
  write_image(directory / "a.PNG", image);
  write_image(directory / "a.bmp", image);
  write_image(directory / "a.Bmp", image);
  CHECK(get(directory / "a.png") == encode_png(image));
  CHECK(get(directory / "a.PNG") == encode_png(image));
  CHECK(get(directory / "a.bmp") == encode_bmp(image));
  CHECK(get(directory / "a.Bmp") == encode_bmp(image));
}

TEST_CASE("a file that is missing, no file or no picture cannot be read, and the reason says so") {
  const TemporaryFolder directory;
  CHECK(reason([&] { read_image(directory / "none.png"); }) == "no such file");
  CHECK(reason([&] { read_image(directory / "none" / "none.png"); }) == "no such file");
  CHECK(reason([&] { read_image(""); }) == "no such file");
  CHECK(reason([&] { read_image(directory.path()); }) == "is a directory");
  CHECK(reason([] { read_image("/dev/zero"); }) == "not a regular file");
  put(directory / "text.png", Bytes{'S', 'B', 'T', '-', 'r', 'a', 'y', 't', 'r', 'a', 'c', 'e', 'r'});
  CHECK(reason([&] { read_image(directory / "text.png"); }) == "not a picture this program can read");
  put(directory / "empty.png", {});
  CHECK(reason([&] { read_image(directory / "empty.png"); }) == "not a picture this program can read");
}

TEST_CASE("a pipe without a writer is refused at once") {
  const TemporaryFolder directory;
  REQUIRE(mkfifo((directory / "pipe.png").c_str(), 0600) == 0);
  CHECK(reason([&] { read_image(directory / "pipe.png"); }) == "not a regular file");
}

TEST_CASE("a picture of an unknown type cannot be written, and nothing is left") {
  const TemporaryFolder directory;
  const Image image = colourful(2, 2);
  CHECK(reason([&] { write_image(directory / "a.xyz", image); }) == "cannot write pictures of type '.xyz'");
  CHECK(reason([&] { write_image(directory / "a", image); }) ==
        "the name has no extension that tells the type of picture");
  CHECK(reason([&] { write_image(directory / "a.png", Image{}); }) ==
        "a picture of 0 x 0 pixels holds nothing");
  CHECK(directory.names().empty());
}

TEST_CASE(
    "whether a picture can be written is known before there is one, and nothing is left of the question") {
  const TemporaryFolder directory;
  CHECK(reason([&] { check_writable(directory / "a.png"); }) == "no error");
  CHECK(reason([&] { check_writable(directory / "a.xyz"); }) == "cannot write pictures of type '.xyz'");
  CHECK(reason([&] { check_writable(directory / "none" / "a.png"); }) == "no such directory");
  CHECK(directory.names().empty());
  put(directory / "old.png", {1, 2, 3});
  CHECK(reason([&] { check_writable(directory / "old.png"); }) == "no error");
  CHECK(get(directory / "old.png") == Bytes{1, 2, 3});
}

TEST_CASE("a pipe is not opened to ask whether it can be written") {
  const TemporaryFolder directory;
  REQUIRE(mkfifo((directory / "pipe.png").c_str(), 0600) == 0);  // opening it would wait for a reader
  CHECK(reason([&] { check_writable(directory / "pipe.png"); }) == "no error");
}

TEST_CASE("a program that reads and writes pictures is not linked to OpenImageIO") {
  const std::string command = "ldd " + std::filesystem::read_symlink("/proc/self/exe").string();
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  REQUIRE(pipe);
  std::string libraries;
  for (int c; (c = std::fgetc(pipe.get())) != EOF;) libraries += char(c);
  CHECK_THAT(libraries, Catch::Contains("libc.so"));
  CHECK_THAT(libraries, !Catch::Contains("OpenImageIO"));
}
