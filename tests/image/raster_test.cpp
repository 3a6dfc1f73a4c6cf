// What a picture file means to one who measures it.
#include "image/raster.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "float_files.hpp"
#include "image/raster_files.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Raster raster_of(const Bytes& bytes, const std::string& name = "file") {
  const TemporaryFolder directory;
  put(directory / name, bytes);
  return read_raster(directory / name);
}

std::vector<float> over(float most, const std::vector<int>& values) {
  std::vector<float> samples;
  for (const int value : values) samples.push_back(static_cast<float>(value) / most);
  return samples;
}

}  // namespace

TEST_CASE("an 8-bit PNG is read as it is stored, without gamma") {
  const Bytes gamma = chunk("gAMA", big_endian(100000));
  const Raster raster = raster_of(png_file(2, 1, 8, PngColour::rgb, gamma, {0, 128, 64, 32, 0, 255, 1}));
  CHECK(raster.width == 2);
  CHECK(raster.height == 1);
  CHECK(raster.channels == 3);
  CHECK(raster.type == SampleType::uint8);
  CHECK(raster.samples == over(255, {128, 64, 32, 0, 255, 1}));
}

TEST_CASE("a 16-bit PNG keeps all its bits") {
  const Raster raster = raster_of(png_file(1, 1, 16, PngColour::rgb, {}, {0, 0x12, 0x34, 0, 1, 0xff, 0xff}));
  CHECK(raster.type == SampleType::uint16);
  CHECK(raster.samples == over(65535, {0x1234, 1, 65535}));
}

TEST_CASE("gray and alpha stay channels of their own") {
  const Raster gray = raster_of(png_file(2, 1, 8, PngColour::gray, {}, {0, 7, 9}));
  CHECK(gray.channels == 1);
  CHECK(gray.samples == over(255, {7, 9}));
  const Raster two = raster_of(png_file(1, 1, 8, PngColour::gray_alpha, {}, {0, 7, 0}));
  CHECK(two.channels == 2);
  CHECK(two.samples == over(255, {7, 0}));
  const Raster four = raster_of(png_file(1, 1, 16, PngColour::rgba, {}, {0, 0, 1, 0, 2, 0, 3, 0, 0}));
  CHECK(four.channels == 4);
  CHECK(four.samples == over(65535, {1, 2, 3, 0}));
}

TEST_CASE("gray of few bits is spread over all levels, a palette is expanded") {
  CHECK(raster_of(png_file(2, 1, 1, PngColour::gray, {}, {0, 0b01000000})).samples == over(255, {0, 255}));
  const Bytes palette = chunk("PLTE", {10, 20, 30, 40, 50, 60});
  const Raster raster = raster_of(png_file(2, 1, 8, PngColour::palette, palette, {0, 1, 0}));
  CHECK(raster.channels == 3);
  CHECK(raster.samples == over(255, {40, 50, 60, 10, 20, 30}));
}

TEST_CASE("a tRNS chunk is an alpha channel") {
  const Bytes chunks = chunk("PLTE", {10, 20, 30, 40, 50, 60}) + chunk("tRNS", {128});
  const Raster raster = raster_of(png_file(2, 1, 8, PngColour::palette, chunks, {0, 1, 0}));
  CHECK(raster.channels == 4);
  CHECK(raster.samples == over(255, {40, 50, 60, 255, 10, 20, 30, 128}));
}

TEST_CASE("an interlaced PNG to be measured is read like another") {
  const Bytes passes{0, 1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 10, 11, 12};
  CHECK(raster_of(png_file(2, 2, 8, PngColour::rgb, {}, passes, true)).samples ==
        over(255, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST_CASE("an 8-bit picture in memory, as BMP and as PNG are the same") {
  const TemporaryFolder directory;
  const Image image = colourful(7, 5);
  write_image(directory / "a.bmp", image);
  write_image(directory / "a.png", image);
  const Raster memory = to_raster(image);
  CHECK(memory.samples == read_raster(directory / "a.bmp").samples);
  CHECK(memory.samples == read_raster(directory / "a.png").samples);
  CHECK(memory.type == SampleType::uint8);
  CHECK(memory.pixel(6, 4)[1] == static_cast<float>(image.rgb[3 * (4 * 7 + 6) + 1]) / 255);
}

TEST_CASE("floating-point samples are read as they are, NaN and infinity among them") {
  const float nan_sample = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const Raster raster =
      raster_of(exr_file(2, 2, {"B", "G", "R"},
                         {0.25F, -1, 7.5F, nan_sample, infinite, -infinite, 0, 1, 2, 3, 4, 1e-20F}),
                "a.exr");
  CHECK(raster.type == SampleType::real);
  REQUIRE(raster.channels == 3);
  CHECK(raster.pixel(0, 0)[0] == 7.5F);  // red
  CHECK(raster.pixel(0, 0)[1] == -1);
  CHECK(raster.pixel(0, 0)[2] == 0.25F);
  CHECK(std::isnan(raster.pixel(1, 0)[2]));
  CHECK(raster.pixel(1, 0)[1] == infinite);
  CHECK(raster.pixel(1, 0)[0] == -infinite);
  CHECK(raster.pixel(1, 1)[0] == 1e-20F);
}

TEST_CASE("OpenImageIO's formats tell their type of sample") {
  const Raster gray = raster_of(Bytes{'P', '5', '\n', '2', ' ', '1', '\n', '2', '5', '5', '\n', 0, 77});
  CHECK(gray.type == SampleType::uint8);
  CHECK(gray.channels == 1);
  CHECK(gray.samples == over(255, {0, 77}));
  const Raster wide =
      raster_of(Bytes{'P', '5', '\n', '1', ' ', '1', '\n', '6', '5', '5', '3', '5', '\n', 0x12, 0x34});
  CHECK(wide.type == SampleType::uint16);
  CHECK(wide.samples == over(65535, {0x1234}));
}

TEST_CASE("colours under alpha are not multiplied by it") {
  // An uncompressed TARGA of 2 x 1 pixels, blue, green, red, alpha.
  const Raster raster = raster_of(Bytes{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0} + little_endian(2, 2) +
                                      little_endian(1, 2) + Bytes{32, 8, 30, 20, 10, 0, 60, 50, 40, 128},
                                  "a.tga");
  CHECK(raster.channels == 4);
  CHECK(raster.samples == over(255, {10, 20, 30, 0, 40, 50, 60, 128}));
}

TEST_CASE("a picture of very many channels is refused before its samples are read") {
  std::vector<std::string> channels;
  for (int i = 0; i < 1000; ++i) channels.push_back("c" + std::to_string(1000 + i));
  const Bytes file = exr_file(1, 1, channels, std::vector<float>(1000, 0.0F));
  CHECK(reason([&] { raster_of(file, "a.exr"); }) == "1000 channels are not between 1 and 16");
}

TEST_CASE("a small PNG that claims a large picture is refused before memory is taken for it") {
  const Bytes file = png_file(16384, 16384, 16, PngColour::rgba, {}, {0, 0, 0});
  CHECK(reason([&] { raster_of(file); }) == "the PNG ends too early");
}

TEST_CASE("a picture of more samples than can be measured is refused") {
  // Its rows could be as small as this file, were they all equal.
  Bytes file = png_file(16384, 16384, 8, PngColour::rgba, {}, {0});
  file.resize(1100000);
  CHECK(reason([&] { raster_of(file); }) ==
        "16384 x 16384 pixels of 4 channels are too many to measure: at most 268435456 samples");
}

TEST_CASE("what is wrong with a file to be measured is told as for textures") {
  CHECK(reason([] { read_raster("/nowhere/a.png"); }) == "no such file");
  CHECK(reason([] { read_raster("/"); }) == "is a directory");
  CHECK(reason([] { raster_of({'x', 'y'}); }) == "not a picture this program can read");
  CHECK(reason([] { raster_of({}); }) == "not a picture this program can read");
  Bytes half = png_file(4, 4, 8, PngColour::rgb, {}, Bytes(4 * 13, 0));
  half.resize(half.size() / 2);
  CHECK(reason([&] { raster_of(half); }) == "the PNG ends too early");
  CHECK_THAT(reason([] {
               raster_of(Bytes{'I', 'I', '*', 0, 8, 0, 0, 0});
             }),
             Catch::StartsWith("the TIFF cannot be read: "));
  CHECK_THAT(reason([] {
               raster_of(Bytes{'v', '/', '1', 1, 2, 0, 0, 0, 'x'});
             }),
             Catch::StartsWith("the OpenEXR cannot be read: "));
}

TEST_CASE("without the module the error of measuring names the package to install") {
  const TemporaryFolder directory;
  CHECK_THAT(reason([&] { read_raster_with_openimageio("a.exr", "OpenEXR", {directory / "none.so"}); }),
             Catch::StartsWith("reading OpenEXR needs OpenImageIO: install the package "));
}
