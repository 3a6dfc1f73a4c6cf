#include "scene/cube_map.hpp"

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Each face holds u in red, v in green and its own number (0 to 5: +x -x +y -y posz negz) in blue.
const CubeMap& coordinates() {
  static const CubeMap map = [] {
    std::vector<Texture> faces;
    for (std::uint8_t f = 0; f < 6; ++f) {
      faces.emplace_back(Image{2, 2, {0, 255, f, 255, 255, f, 0, 0, f, 255, 0, f}});
    }
    return CubeMap(std::move(faces));
  }();
  return map;
}

int face(const Vec3& d) {
  return static_cast<int>(std::lround(coordinates().lookup(d).z * 255));
}

struct Case {
  Vec3 direction;
  int face;
  double u2, v2;  // 2u - 1 and 2v - 1 by docs/language.md section 10
};

}  // namespace

TEST_CASE("each direction sees its face of the cube map, the right way round") {
  const Case c = GENERATE(Case{{1, 0.5, 0.2}, 0, 0.2, 0.5},    // z/a, y/a
                          Case{{-1, 0.5, 0.2}, 1, -0.2, 0.5},  // -z/a, y/a
                          Case{{0.2, 1, 0.5}, 2, 0.2, 0.5},    // x/b, z/b
                          Case{{0.2, -1, 0.5}, 3, 0.2, -0.5},  // x/b, -z/b
                          Case{{0.2, 0.5, -1}, 4, 0.2, 0.5},   // -z is posz: x/c, y/c
                          Case{{0.2, 0.5, 1}, 5, -0.2, 0.5});  // +z is negz: -x/c, y/c
  const double length = GENERATE(1.0, 3.0);                    // only the direction counts
  const Rgb seen = coordinates().lookup(length * c.direction);
  CHECK(face(c.direction) == c.face);
  CHECK(2 * seen.x - 1 == about(c.u2));
  CHECK(2 * seen.y - 1 == about(c.v2));
}

TEST_CASE("on the edges of the cube y goes before x and z before both") {
  const double x = GENERATE(-1.0, 1.0), y = GENERATE(-1.0, 1.0), z = GENERATE(-1.0, 1.0);
  CHECK(face({x, y, z}) == (z < 0 ? 4 : 5));
  CHECK(face({x, 0.5, z}) == (z < 0 ? 4 : 5));
  CHECK(face({0.5, y, z}) == (z < 0 ? 4 : 5));
  CHECK(face({x, y, 0.5}) == (y > 0 ? 2 : 3));
}

TEST_CASE("a cube map does not filter across its edges") {
  // At the very edge of +x the colour is that of the face's border.
  const Rgb seen = coordinates().lookup({1, 0, 1 - 1e-15});
  CHECK(seen == near(1, 0.5, 0));
}

TEST_CASE("faces of a cube map may differ in size") {
  std::vector<Texture> faces;
  for (int f = 0; f < 6; ++f) {
    faces.emplace_back(
        Image{f + 1, 1, std::vector<std::uint8_t>(3 * (f + 1), static_cast<std::uint8_t>(40 * f))});
  }
  const CubeMap map(std::move(faces));
  CHECK(map.lookup({1, 0, 0}) == near(Vec3(0)));
  CHECK(map.lookup({0.3, 0.2, 1}) == near(Vec3(200 / 255.0)));
}

TEST_CASE("a direction that is none sees some colour of the cube map, and nothing breaks") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(is_finite(coordinates().lookup(Vec3(0))));
  CHECK(is_finite(coordinates().lookup(Vec3(nan))));
}
