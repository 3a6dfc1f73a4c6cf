#include "image/picture_file.hpp"

#include <catch2/catch.hpp>

#include "image/png.hpp"
#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("nothing is seen of a picture's place before the picture is written") {
  const TemporaryFolder directory;
  const Image image = colourful(6, 5);
  PictureFile file(directory / "a.png");
  CHECK(directory.names().empty());
  file.write(image);
  CHECK(get(directory / "a.png") == encode_png(image));
  CHECK(directory.names() == std::vector<std::string>{"a.png"});
  { const PictureFile dropped(directory / "b.png"); }
  CHECK(directory.names() == std::vector<std::string>{"a.png"});
}

TEST_CASE("a picture replaces what came to its place after that was found writable") {
  const TemporaryFolder directory;
  const Image image = colourful(6, 5);
  PictureFile file(directory / "a.png");
  put(directory / "a.png", Bytes{1, 2, 3});
  file.write(image);
  CHECK(get(directory / "a.png") == encode_png(image));
  CHECK(directory.names() == std::vector<std::string>{"a.png"});
}

TEST_CASE("a picture's place refuses what write_image refuses") {
  const TemporaryFolder directory;
  for (const char* name : {"a", "a.xyz", "none/a.png"}) {
    const std::string expected = reason([&] { write_image(directory / name, colourful(6, 5)); });
    CHECK(expected != "no error");
    CHECK(reason([&] { PictureFile(directory / name); }) == expected);
  }
}
