#include <catch2/catch.hpp>

#include "image/bmp.hpp"
#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// The two headers of a BMP file; `offset` is where its pixels start.
Bytes header(std::int32_t width, std::int32_t height, int bits, std::uint32_t offset,
             std::uint32_t compression = 0) {
  return Bytes{'B', 'M'} + little_endian(0) + little_endian(0) + little_endian(offset) + little_endian(40) +
         little_endian(std::uint32_t(width)) + little_endian(std::uint32_t(height)) + little_endian(1, 2) +
         little_endian(std::uint32_t(bits), 2) + little_endian(compression) + Bytes(20);
}

}  // namespace

TEST_CASE("a picture written as BMP is read back byte for byte, whatever its rows are padded to") {
  const int width = GENERATE(1, 2, 3, 4, 5, 64);
  const Image image = colourful(width, 7);
  const Image back = read_bytes(encode_bmp(image));
  CHECK(back.width == width);
  CHECK(back.height == 7);
  CHECK(back.rgb == image.rgb);
}

TEST_CASE("a BMP is written with 24 bits a pixel, blue first, from the bottom row up") {
  const Image image{1, 2, {1, 2, 3, 4, 5, 6}};
  Bytes file = encode_bmp(image);
  CHECK(file.size() == 54 + 8);
  CHECK(Bytes(file.begin(), file.begin() + 2) == Bytes{'B', 'M'});
  CHECK(file[28] == 24);
  CHECK(Bytes(file.begin() + 54, file.end()) == Bytes{6, 5, 4, 0, 3, 2, 1, 0});
}

TEST_CASE("a BMP of negative height starts at the top") {
  CHECK(read_bytes(header(1, -2, 24, 54) + Bytes{3, 2, 1, 0, 6, 5, 4, 0}).rgb == Bytes{1, 2, 3, 4, 5, 6});
}

TEST_CASE("a BMP may leave a gap before its pixels and leave out the last padding") {
  CHECK(read_bytes(header(1, 2, 24, 60) + Bytes(6) + Bytes{6, 5, 4, 0, 3, 2, 1}).rgb ==
        Bytes{1, 2, 3, 4, 5, 6});
}

TEST_CASE("a BMP with a palette is expanded to RGB") {
  const Bytes palette{3, 2, 1, 0, 6, 5, 4, 0};
  CHECK(read_bytes(header(2, 1, 8, 62) + palette + Bytes{1, 0, 0, 0}).rgb == Bytes{4, 5, 6, 1, 2, 3});
  CHECK(read_bytes(header(2, 1, 4, 62) + palette + Bytes{0x10, 0, 0, 0}).rgb == Bytes{4, 5, 6, 1, 2, 3});
  CHECK(read_bytes(header(2, 1, 1, 62) + palette + Bytes{0x80, 0, 0, 0}).rgb == Bytes{4, 5, 6, 1, 2, 3});
}

TEST_CASE("a BMP's pixels beyond its palette are black") {
  CHECK(read_bytes(header(2, 1, 8, 58) + Bytes{3, 2, 1, 0} + Bytes{0, 200, 0, 0}).rgb ==
        Bytes{1, 2, 3, 0, 0, 0});
}

TEST_CASE("a BMP of 16 or 32 bits a pixel is read, alpha dropped") {
  CHECK(read_bytes(header(1, 1, 32, 54) + Bytes{3, 2, 1, 0}).rgb == Bytes{1, 2, 3});
  CHECK(read_bytes(header(1, 1, 16, 54) + Bytes{0x00, 0x7c}).rgb == Bytes{255, 0, 0});
  const Bytes masks = little_endian(0xff) + little_endian(0xff00) + little_endian(0xff0000);
  CHECK(read_bytes(header(1, 1, 32, 66, 3) + masks + Bytes{1, 2, 3, 0}).rgb == Bytes{1, 2, 3});
}

TEST_CASE("a BMP cut short anywhere is an error") {
  const Bytes whole = encode_bmp(colourful(4, 3));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    INFO("length " << length);
    const Bytes part(whole.begin(), whole.begin() + std::ptrdiff_t(length));
    REQUIRE(reason([&] { read_bytes(part); }) ==
            (length < 2 ? "not a picture this program can read" : "the BMP ends too early"));
  }
}

TEST_CASE("a BMP with any single bit flipped is an error or a picture of the size it says") {
  const Bytes palette{3, 2, 1, 0, 6, 5, 4, 0};
  const Bytes whole =
      GENERATE_COPY(encode_bmp(colourful(4, 3)), header(2, 1, 4, 62) + palette + Bytes{0x10, 0, 0, 0},
                    header(1, 1, 32, 66, 3) + Bytes(12, 0x0f) + Bytes{1, 2, 3, 0});
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    INFO("bit " << bit);
    Bytes damaged = whole;
    damaged[bit / 8] ^= std::uint8_t(1 << bit % 8);
    try {
      const Image image = read_bytes(damaged);
      REQUIRE(image.rgb.size() == std::size_t(3 * image.width * image.height));
    } catch (const ImageError& error) {
      REQUIRE(std::string(error.what()) != "");
    }
  }
}

TEST_CASE("a BMP this program cannot read says what is unusual about it") {
  CHECK(reason([] { read_bytes(header(1, 1, 8, 54, 1) + Bytes(8)); }) == "a compressed BMP cannot be read");
  CHECK(reason([] { read_bytes(header(1, 1, 48, 54) + Bytes(8)); }) ==
        "a BMP of 48 bits a pixel cannot be read");
  CHECK(reason([] { read_bytes(header(1, 1, 24, 20) + Bytes(8)); }) == "the BMP is damaged: bad offset");
  const Bytes os2 = Bytes{'B', 'M'} + Bytes(8) + little_endian(26) + little_endian(12) + little_endian(1, 2) +
                    little_endian(1, 2) + little_endian(1, 2) + little_endian(8, 2) + Bytes(4);
  CHECK(reason([&] { read_bytes(os2); }) == "a BMP of OS/2 with a palette cannot be read");
}

TEST_CASE("a BMP that claims too large a picture is refused") {
  CHECK(reason([] { read_bytes(header(65537, 1, 24, 54)); }) ==
        "65537 x 1 pixels are too many: a side may have at most 65536");
  CHECK(reason([] { read_bytes(header(65536, 4097, 24, 54)); }) ==
        "65536 x 4097 pixels are too many: a picture may have at most 268435456");
  CHECK(reason([] { read_bytes(header(-1, 1, 24, 54)); }) == "a picture of -1 x 1 pixels holds nothing");
  CHECK(reason([] { read_bytes(header(1, INT32_MIN, 24, 54)); }) ==
        "1 x 2147483648 pixels are too many: a side may have at most 65536");
  CHECK(reason([] { read_bytes(header(60000, 4000, 24, 54)); }) == "the BMP ends too early");
}
