#include <catch2/catch.hpp>

#include "image/png.hpp"
#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a picture written as PNG is read back byte for byte") {
  const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {7, 5}, {64, 64}, {1000, 3}, {3, 1000}}));
  const Image image = colourful(width, height);
  const Image back = read_bytes(encode_png(image));
  CHECK(back.width == width);
  CHECK(back.height == height);
  CHECK(back.rgb == image.rgb);
}

TEST_CASE("a PNG is written as 8-bit RGB, not interlaced, with nothing but the picture in it") {
  const Bytes file = encode_png(colourful(300, 200));
  const Bytes header = big_endian(300) + big_endian(200) + Bytes{8, std::uint8_t(PngColour::rgb), 0, 0, 0};
  CHECK(Bytes(file.begin() + 16, file.begin() + 29) == header);

  std::string types;
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const std::string type(file.begin() + std::ptrdiff_t(at) + 4, file.begin() + std::ptrdiff_t(at) + 8);
    if (!types.ends_with(type)) types += " " + type;
    at += 12 + (std::size_t{file[at]} << 24 | file[at + 1] << 16 | file[at + 2] << 8 | file[at + 3]);
  }
  CHECK(types == " IHDR IDAT IEND");
}

TEST_CASE("the same picture gives the same PNG bytes") {
  CHECK(encode_png(colourful(50, 40)) == encode_png(colourful(50, 40)));
  const Image large = colourful(700, 500);  // several stripes
  const Bytes alone = encode_png(large, 1);
  for (const int threads : {2, 3, 8}) CHECK(encode_png(large, threads) == alone);
  CHECK(read_bytes(alone).rgb == large.rgb);
}

TEST_CASE("a picture whose pixels do not match its size is not written") {
  CHECK(reason([] {
          encode_png(Image{2, 2, Bytes(11)});
        }) == "a picture of 2 x 2 pixels needs 12 bytes, not 11");
  CHECK(reason([] { encode_png(Image{}); }) == "a picture of 0 x 0 pixels holds nothing");
}
