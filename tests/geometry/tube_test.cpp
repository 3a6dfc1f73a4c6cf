// Cylinders without caps.
#include "geometry/cylinder.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a tube is hit at its side from outside and from inside, with the normal towards the ray") {
  const auto outside = meet(Tube{}, {5, 0, 0.5}, {-1, 0, 0});
  REQUIRE(outside);
  CHECK(outside->t == 4);
  CHECK(outside->normal == near(1, 0, 0));
  const auto inside = meet(Tube{}, {0, 0, 0.5}, {-1, 0, 0});
  REQUIRE(inside);
  CHECK(inside->t == 1);
  CHECK(inside->normal == near(1, 0, 0));
}

TEST_CASE("a tube is open at its ends") {
  CHECK_FALSE(meet(Tube{}, {0.5, 0, 5}, {0, 0, -1}));
  CHECK_FALSE(meet(Tube{}, {0, 0, 5}, {0, 0, -1}));
  // In through the open end, onto the inner side.
  const auto through = meet(Tube{}, {-1, 0, 2.5}, {1, 0, -1});
  REQUIRE(through);
  CHECK(through->t == about(2 * std::sqrt(2.0)));
  CHECK(through->normal == near(-1, 0, 0));
}

TEST_CASE("a tube from outside is hit where the side of a cylinder is") {
  Random random(5);
  int same = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = 3.0 * random.in_cube(1);
    const Ray ray{origin, glm::normalize(random.in_cube(1) - origin)};
    LocalHit cylinder, tube;
    if (!Cylinder{}.intersect(ray, cylinder) || cylinder.normal.z != 0) continue;
    REQUIRE(Tube{}.intersect(ray, tube));
    CHECK(tube.t == cylinder.t);
    ++same;
  }
  CHECK(same > 300);
}

TEST_CASE("a ray that leaves a tube inward meets its other side") {
  LocalHit hit;
  REQUIRE(Tube{}.intersect({{1, 0, 0.5}, {-1, 0, 0}, 1e-15}, hit));
  CHECK(hit.t == about(2));
  CHECK_FALSE(Tube{}.intersect({{1, 0, 0.5}, {1, 0, 0}, 1e-15}, hit));
}
