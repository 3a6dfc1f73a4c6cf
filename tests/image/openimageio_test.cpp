#include "image/openimageio.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

namespace {

int largest_difference(const Bytes& left, const Bytes& right) {
  REQUIRE(left.size() == right.size());
  int largest = 0;
  for (std::size_t i = 0; i < left.size(); ++i) largest = std::max(largest, std::abs(left[i] - right[i]));
  return largest;
}

// 8 x 8 pixels of one colour, which even JPEG keeps.
Image plain() {
  Image image{8, 8, {}};
  for (int i = 0; i < 64; ++i) image.rgb.insert(image.rgb.end(), {200, 100, 50});
  return image;
}

}  // namespace

TEST_CASE("formats without loss are written and read back byte for byte") {
  const std::string extension = GENERATE(".tif", ".TIFF", ".exr", ".tga", ".ppm", ".pnm", ".sgi", ".dpx");
  const TemporaryFolder directory;
  const std::filesystem::path file = directory / ("picture" + extension);
  const Image image = colourful(12, 10);
  write_image(file, image);
  const Image back = read_image(file);
  CHECK(back.width == 12);
  CHECK(back.height == 10);
  CHECK(back.rgb == image.rgb);
  CHECK(directory.names() == std::vector<std::string>{"picture" + extension});
}

TEST_CASE("formats with loss are written and read back with small differences") {
  const std::string extension = GENERATE(".jpg", ".jpeg", ".webp", ".gif", ".hdr");
  const TemporaryFolder directory;
  const std::filesystem::path file = directory / ("picture" + extension);
  write_image(file, plain());
  const Image back = read_image(file);
  CHECK(back.width == 8);
  CHECK(back.height == 8);
  CHECK(largest_difference(back.rgb, plain().rgb) <= 3);
}

TEST_CASE("a gray picture read by OpenImageIO has three equal channels") {
  const Bytes file{'P', '5', '\n', '3', ' ', '1', '\n', '2', '5', '5', '\n', 0, 77, 255};
  CHECK(read_bytes(file).rgb == Bytes{0, 0, 0, 77, 77, 77, 255, 255, 255});
}

TEST_CASE("alpha in a picture read by OpenImageIO is dropped, the colours stay as they are") {
  const TemporaryFolder directory;
  // An uncompressed TARGA of 2 x 1 pixels, blue, green, red, alpha.
  put(directory / "a.tga", Bytes{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0} + little_endian(2, 2) +
                               little_endian(1, 2) + Bytes{32, 8, 30, 20, 10, 0, 60, 50, 40, 128});
  CHECK(read_image(directory / "a.tga").rgb == Bytes{10, 20, 30, 40, 50, 60});
}

TEST_CASE("the limits of size hold for OpenImageIO's formats too") {
  const std::string text = "P6\n65537 1\n255\n";
  const Bytes file(text.begin(), text.end());
  CHECK(reason([&] { read_bytes(file); }) == "65537 x 1 pixels are too many: a side may have at most 65536");
}

TEST_CASE("a damaged file is an error that names its format") {
  CHECK_THAT(reason([] {
               read_bytes(Bytes{0xff, 0xd8, 0xff, 0xe0, 0, 16, 'J', 'F', 'I', 'F', 0, 1});
             }),
             Catch::StartsWith("the JPEG cannot be read: "));
  CHECK_THAT(reason([] {
               read_bytes(Bytes{'I', 'I', '*', 0, 8, 0, 0, 0});
             }),
             Catch::StartsWith("the TIFF cannot be read: "));
}

TEST_CASE("without the module the error names the package to install") {
  const TemporaryFolder directory;
  const ModulePlaces nowhere{directory / "trace_openimageio.so"};
  CHECK(reason([&] { read_with_openimageio(directory / "a.jpg", "JPEG", nowhere); }) ==
        "reading JPEG needs OpenImageIO: install the package libopenimageio2.4, and trace_openimageio.so "
        "beside "
        "the program");
  CHECK(reason([&] { encode_with_openimageio(plain(), "TIFF", ".tif", nowhere); }) ==
        "writing TIFF needs OpenImageIO: install the package libopenimageio2.4, and trace_openimageio.so "
        "beside "
        "the program");
}

TEST_CASE("without OpenImageIO itself the error names the package to install") {
  // A copy of the module that asks for a library nobody has.
  const ModulePlaces places = openimageio_places();
  const auto module =
      std::ranges::find_if(places, [](const auto& place) { return std::filesystem::exists(place); });
  REQUIRE(module != places.end());
  Bytes bytes = get(*module);
  const std::string_view library = "libOpenImageIO.so", unknown = "libOpenImageXX.so";
  auto at = std::search(bytes.begin(), bytes.end(), library.begin(), library.end());
  REQUIRE(at != bytes.end());
  std::copy(unknown.begin(), unknown.end(), at);

  const TemporaryFolder directory;
  put(directory / "trace_openimageio.so", bytes);
  CHECK(reason([&] { read_with_openimageio("a.jpg", "JPEG", {directory / "trace_openimageio.so"}); }) ==
        "reading JPEG needs OpenImageIO: install the package libopenimageio2.4");
}

TEST_CASE("a file that is no module is refused") {
  const TemporaryFolder directory;
  put(directory / "trace_openimageio.so", Bytes{'n', 'o', 'n', 'e'});
  CHECK_THAT(reason([&] { read_with_openimageio("a.jpg", "JPEG", {directory / "trace_openimageio.so"}); }),
             Catch::StartsWith("reading JPEG needs OpenImageIO, which cannot be loaded: "));
}

TEST_CASE("the module is looked for beside the program and in lib/trace") {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  CHECK(openimageio_places() == ModulePlaces{program / "trace_openimageio.so",
                                             program.parent_path() / "lib/trace/trace_openimageio.so"});
}
