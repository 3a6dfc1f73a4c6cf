// PNG files that are not what they should be.
#include <catch2/catch.hpp>

#include "image/png.hpp"
#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a PNG cut short anywhere is an error") {
  const Bytes whole = encode_png(colourful(9, 7));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    INFO("length " << length);
    const Bytes part(whole.begin(), whole.begin() + std::ptrdiff_t(length));
    REQUIRE(reason([&] { read_bytes(part); }) ==
            (length < 8 ? "not a picture this program can read" : "the PNG ends too early"));
  }
}

TEST_CASE("a PNG with any single bit flipped is an error") {
  const Bytes whole = encode_png(colourful(5, 4));
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    INFO("bit " << bit);
    Bytes damaged = whole;
    damaged[bit / 8] ^= std::uint8_t(1 << bit % 8);
    REQUIRE(reason([&] { read_bytes(damaged); }) != "no error");
  }
}

TEST_CASE("a damaged PNG is reported with libpng's reason") {
  Bytes damaged = encode_png(colourful(5, 4));
  damaged[damaged.size() - 13] ^= 1;  // the last byte before IEND: the CRC of the pixels
  CHECK(reason([&] { read_bytes(damaged); }) == "the PNG is damaged: IDAT: CRC error");
}

TEST_CASE("a PNG whose rows are fewer than it says is an error") {
  CHECK(reason([] {
          read_bytes(png_file(1, 2, 8, PngColour::gray, {}, {0, 1}));
        }) == "the PNG is damaged: Not enough image data");
}

TEST_CASE("a PNG whose pixels point beyond its palette gives some picture or an error") {
  const Bytes file = png_file(2, 1, 8, PngColour::palette, chunk("PLTE", {1, 2, 3}), {0, 0, 255});
  const std::string outcome = reason([&] { CHECK(read_bytes(file).rgb.size() == 6); });
  CHECK_THAT(outcome, Catch::Equals("no error") || Catch::StartsWith("the PNG is damaged: "));
}

TEST_CASE("a PNG with too large a side is refused") {
  CHECK(reason([] { read_bytes(png_file(65537, 1, 8, PngColour::rgb, {}, {0})); }) ==
        "65537 x 1 pixels are too many: a side may have at most 65536");
}

TEST_CASE("a PNG with too many pixels is refused") {
  CHECK(reason([] { read_bytes(png_file(65536, 4097, 8, PngColour::rgb, {}, {0})); }) ==
        "65536 x 4097 pixels are too many: a picture may have at most 268435456");
}

TEST_CASE("a small PNG that claims a large picture is refused before there is memory for it") {
  CHECK(reason([] { read_bytes(png_file(65536, 4096, 8, PngColour::rgb, {}, {0})); }) ==
        "the PNG ends too early");
}
