#include "comparison/heat_map.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "comparison/viridis.hpp"
#include "rasters.hpp"

using namespace trace;
using namespace trace::test;

namespace {

MapColor at(const Image& image, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

bool any_white(const Image& image, int from_y, int to_y) {
  for (int y = from_y; y < to_y; ++y)
    for (int x = 0; x < image.width; ++x)
      if (at(image, x, y) == MapColor{255, 255, 255}) return true;
  return false;
}

double luminance(const MapColor& c) {
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

}  // namespace

TEST_CASE("the map of identical pictures is the colour of 0 everywhere") {
  const Image map = heat_map(noise(8, 6, 1), noise(8, 6, 1));
  CHECK(map.width == 8);
  CHECK(map.height == 6);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) CHECK(at(map, x, y) == viridis(0));
}

TEST_CASE("the map shows the largest difference over the channels, amplified") {
  Raster reference = uniform(3, 1, 3, 0), test = reference;
  set(test, 1, 0, 2, 51);
  set(test, 2, 0, 1, 255);
  CHECK(at(heat_map(reference, test), 1, 0) == viridis(0.2));
  CHECK(at(heat_map(reference, test), 2, 0) == viridis(1));
  CHECK(at(heat_map(reference, test, 2), 1, 0) == viridis(0.4));
  CHECK(at(heat_map(reference, test, 10), 1, 0) == viridis(1));
}

TEST_CASE("a pixel that is not finite has a colour of its own") {
  const Image map =
      heat_map(floats(2, 1, 1, {0, 0}), floats(2, 1, 1, {std::numeric_limits<float>::quiet_NaN(), 1}));
  CHECK(at(map, 0, 0) == MapColor{255, 0, 255});
  CHECK(at(map, 1, 0) == viridis(1));
}

TEST_CASE("a map of one pixel is one pixel") {
  const Image map = heat_map(uniform(1, 1, 1, 0), uniform(1, 1, 1, 255));
  CHECK(map.width == 1);
  CHECK(map.height == 1);
}

TEST_CASE("a map has its scale below it, with labels where there is room") {
  const Image small = heat_map(uniform(16, 4, 3, 0), uniform(16, 4, 3, 9));
  CHECK(small.height == 4 + legend_height);
  CHECK(at(small, 0, 4 + 4) == viridis(0));
  CHECK(at(small, 15, 4 + 4) == viridis(1));
  CHECK_FALSE(any_white(small, 4, small.height));
  const Image large = heat_map(uniform(96, 4, 3, 0), uniform(96, 4, 3, 9));
  CHECK(large.height == 4 + legend_height);
  CHECK(any_white(large, 4, large.height));
}

TEST_CASE("the labels are levels: 128 at the end of a map amplified twice") {
  const Image twice = heat_map(uniform(96, 4, 3, 0), uniform(96, 4, 3, 9), 2);
  const Image once = heat_map(uniform(96, 4, 3, 0), uniform(96, 4, 3, 9), 1);
  CHECK(twice.rgb != once.rgb);
  // The label at the right ends in an 8, whose left side is drawn, and in a 5, whose lower left is not.
  const int x = 96 - 6, top = 4 + 10;
  CHECK(at(twice, x, top + 6) == MapColor{255, 255, 255});
  CHECK(at(once, x, top + 6) == MapColor{0, 0, 0});
}

TEST_CASE("the colours of the map get evenly lighter") {
  for (int i = 0; i < 100; ++i) CHECK(luminance(viridis((i + 1) / 100.0)) > luminance(viridis(i / 100.0)));
  CHECK(viridis(-1) == viridis(0));
  CHECK(viridis(2) == viridis(1));
  CHECK(viridis(0) == MapColor{68, 1, 84});
  CHECK(viridis(1) == MapColor{253, 231, 37});
}
