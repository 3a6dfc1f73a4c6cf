#include "scene/texture.hpp"

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Grey texels, rows from the top, as files have them.
Texture grey(int width, int height, const std::vector<int>& bytes) {
  Image image{width, height, {}};
  for (const int b : bytes) image.rgb.insert(image.rgb.end(), 3, static_cast<std::uint8_t>(b));
  return Texture(image);
}

double value(const Texture& texture, double u, double v) {
  return texture.sample(Vec2(u, v)).x * 255;
}

// 3 x 2:   40  50  60
//          10  20 250
const Texture& small() {
  static const Texture texture = grey(3, 2, {40, 50, 60, 10, 20, 250});
  return texture;
}

}  // namespace

TEST_CASE("v = 0 is the bottom row of a texture") {
  CHECK(value(small(), 0, 0) == about(10));
  CHECK(value(small(), 1, 0) == about(250));
  CHECK(value(small(), 0, 1) == about(40));
  CHECK(value(small(), 1, 1) == about(60));
  CHECK(value(small(), 0.5, 1) == about(50));
}

TEST_CASE("between texels a texture is bilinear, from the first centre to the last") {
  // x = u * 2, y = v * 1.
  CHECK(value(small(), 0.25, 0) == about(15));
  CHECK(value(small(), 0, 0.3) == about(19));
  // At x = 1.5, y = 0.25: (20 + 250)/2 * 0.75 + (50 + 60)/2 * 0.25 = 101.25 + 13.75.
  CHECK(value(small(), 0.75, 0.25) == about(115));
}

TEST_CASE("a texture's channels are read in their order, 255 is one") {
  const Texture texture(Image{1, 1, {255, 51, 0}});
  CHECK(texture.sample(Vec2(0.3, 0.9)) == near(1, 0.2, 0));
}

TEST_CASE("coordinates beyond a texture show its border, undefined ones its lower left corner") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(value(small(), -0.1, 0) == about(10));
  CHECK(value(small(), 1 + 1e-15, 0) == about(250));
  CHECK(value(small(), 1e300, -1e300) == about(250));
  CHECK(value(small(), infinity, infinity) == about(60));
  CHECK(value(small(), -infinity, 2) == about(40));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(value(small(), nan, nan) == about(10));
}

TEST_CASE("a texture one texel wide or high has that texel everywhere along it") {
  const Texture column = grey(1, 2, {200, 100});
  const double u = GENERATE(0.0, 0.5, 1.0);
  CHECK(value(column, u, 0.5) == about(150));
  const Texture row = grey(2, 1, {200, 100});
  CHECK(value(row, 0.5, u) == about(150));
}

TEST_CASE("an even area of a texture keeps its value to the last bit where weights are simple") {
  // Each term is colour * x weight * y weight; with weights 1/2 nothing rounds but the sum, and that is exact
  // too.
  const Texture texture = grey(2, 2, {77, 77, 77, 77});
  CHECK(texture.sample(Vec2(0.5, 0.5)) == Rgb(77 / 255.0));
}

TEST_CASE("a texture knows its size") {
  CHECK(small().width() == 3);
  CHECK(small().height() == 2);
}

TEST_CASE("texels that have width divide the unit square into as many steps as there are texels") {
  Texture texture = grey(2, 2, {0, 100, 200, 240});
  texture.give_texels_width();
  CHECK(value(texture, 0, 0) == Approx(200));
  CHECK(value(texture, 0.25, 0) == Approx(220));  // x = 1/2
  CHECK(value(texture, 0.5, 0) == Approx(240));   // x = 1
  CHECK(value(texture, 0.75, 0) == Approx(240));  // beyond the last texel
  CHECK(value(texture, 1, 1) == Approx(100));
  CHECK(value(texture, 0, 0.25) == Approx(100));  // y = 1/2
}
