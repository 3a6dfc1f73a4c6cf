// What a PNG file means as a texture.
#include <catch2/catch.hpp>

#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// One pixel (128, 64, 32) of 8-bit RGB after the given chunks, as read.
Bytes pixel_after(const Bytes& chunks) {
  return read_bytes(png_file(1, 1, 8, PngColour::rgb, chunks, {0, 128, 64, 32})).rgb;
}

Bytes gamma_chunk(std::uint32_t value) {
  return chunk("gAMA", big_endian(value));
}

}  // namespace

TEST_CASE("a gAMA chunk corrects a PNG to a screen of gamma 2.2, as the course's renderer does") {
  CHECK(pixel_after({}) == Bytes{128, 64, 32});
  CHECK(pixel_after(gamma_chunk(100000)) == Bytes{186, 136, 99});
  CHECK(pixel_after(gamma_chunk(60000)) == Bytes{151, 89, 53});
}

TEST_CASE("a gAMA chunk within 5 % of 1/2.2 changes nothing") {
  CHECK(pixel_after(gamma_chunk(45455)) == Bytes{128, 64, 32});
  CHECK(pixel_after(gamma_chunk(47500)) == Bytes{128, 64, 32});
  CHECK(pixel_after(gamma_chunk(48000)) != Bytes{128, 64, 32});
}

TEST_CASE("a senseless gAMA chunk does not spoil a PNG") {
  CHECK(pixel_after(gamma_chunk(0)) == Bytes{128, 64, 32});
  CHECK(pixel_after(gamma_chunk(0xffffffff)) == Bytes{128, 64, 32});
}

TEST_CASE("an sRGB chunk is not heeded, whether or not there is a gAMA chunk") {
  const Bytes srgb = chunk("sRGB", {0});
  CHECK(pixel_after(srgb) == Bytes{128, 64, 32});
  CHECK(pixel_after(srgb + gamma_chunk(100000)) == Bytes{186, 136, 99});
  CHECK(pixel_after(gamma_chunk(100000) + srgb) == Bytes{186, 136, 99});
}

TEST_CASE("a PNG's damaged colour profile does not matter") {
  CHECK(pixel_after(chunk("iCCP", {'p', 0, 0, 1, 2, 3})) == Bytes{128, 64, 32});
}

TEST_CASE("a PNG with a palette is expanded to RGB, its transparency dropped") {
  const Bytes palette = chunk("PLTE", {10, 20, 30, 40, 50, 60, 70, 80, 90});
  const Bytes rgb{70, 80, 90, 10, 20, 30, 40, 50, 60};
  CHECK(read_bytes(png_file(3, 1, 8, PngColour::palette, palette, {0, 2, 0, 1})).rgb == rgb);
  CHECK(read_bytes(png_file(3, 1, 2, PngColour::palette, palette, {0, 0b10000100})).rgb == rgb);
  const Bytes transparency = chunk("tRNS", {0, 128});
  CHECK(read_bytes(png_file(3, 1, 8, PngColour::palette, palette + transparency, {0, 2, 0, 1})).rgb == rgb);
}

TEST_CASE("the gamma rule applies to palettes, gray and 16 bits too") {
  const Bytes palette = gamma_chunk(100000) + chunk("PLTE", {128, 64, 32});
  CHECK(read_bytes(png_file(1, 1, 8, PngColour::palette, palette, {0, 0})).rgb == Bytes{186, 136, 99});
  CHECK(read_bytes(png_file(1, 1, 8, PngColour::gray, gamma_chunk(100000), {0, 128})).rgb ==
        Bytes{186, 186, 186});
  const Bytes deep{0, 0x80, 0x80, 0x40, 0x40, 0x20, 0x20};
  CHECK(read_bytes(png_file(1, 1, 16, PngColour::rgb, gamma_chunk(100000), deep)).rgb == Bytes{186, 136, 99});
}

TEST_CASE("a gray PNG of any depth is expanded to RGB") {
  CHECK(read_bytes(png_file(2, 1, 1, PngColour::gray, {}, {0, 0b01000000})).rgb ==
        Bytes{0, 0, 0, 255, 255, 255});
  CHECK(read_bytes(png_file(2, 1, 2, PngColour::gray, {}, {0, 0b01100000})).rgb ==
        Bytes{85, 85, 85, 170, 170, 170});
  CHECK(read_bytes(png_file(2, 1, 4, PngColour::gray, {}, {0, 0x5f})).rgb ==
        Bytes{85, 85, 85, 255, 255, 255});
  CHECK(read_bytes(png_file(1, 1, 8, PngColour::gray, {}, {0, 77})).rgb == Bytes{77, 77, 77});
  const Bytes transparency = chunk("tRNS", {0, 77});
  CHECK(read_bytes(png_file(1, 1, 8, PngColour::gray, transparency, {0, 77})).rgb == Bytes{77, 77, 77});
}

TEST_CASE("of 16 bits in a PNG the high byte counts") {
  CHECK(read_bytes(png_file(1, 1, 16, PngColour::gray, {}, {0, 0x12, 0xff})).rgb == Bytes{0x12, 0x12, 0x12});
  CHECK(read_bytes(png_file(1, 1, 16, PngColour::rgb, {}, {0, 0x12, 0xff, 0x34, 0x80, 0x56, 0})).rgb ==
        Bytes{0x12, 0x34, 0x56});
}

TEST_CASE("alpha in a PNG is dropped, the colours stay as they are") {
  CHECK(read_bytes(png_file(2, 1, 8, PngColour::rgba, {}, {0, 1, 2, 3, 0, 4, 5, 6, 128})).rgb ==
        Bytes{1, 2, 3, 4, 5, 6});
  CHECK(read_bytes(png_file(2, 1, 8, PngColour::gray_alpha, {}, {0, 9, 0, 8, 200})).rgb ==
        Bytes{9, 9, 9, 8, 8, 8});
  CHECK(pixel_after(chunk("tRNS", {0, 128, 0, 64, 0, 32})) == Bytes{128, 64, 32});
}

TEST_CASE("an interlaced PNG is read like another") {
  // 2 x 2: the first pass has the pixel (0, 0), the sixth (1, 0), the seventh the second row.
  const Bytes passes{0, 1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 10, 11, 12};
  CHECK(read_bytes(png_file(2, 2, 8, PngColour::rgb, {}, passes, true)).rgb ==
        Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
}
