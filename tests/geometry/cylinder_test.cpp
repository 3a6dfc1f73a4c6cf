#include "geometry/cylinder.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("the side of a cylinder is hit from outside with the normal outward") {
  const auto hit = meet(Cylinder{}, {5, 0.6, 0.5}, {-1, 0, 0});
  REQUIRE(hit);
  CHECK(hit->t == about(4.2));
  CHECK(hit->normal == near(0.8, 0.6, 0));
}

TEST_CASE("the side of a cylinder is hit from inside with the normal still outward") {
  const auto hit = meet(Cylinder{}, {0.5, 0, 0.5}, {1, 0, 0});
  REQUIRE(hit);
  CHECK(hit->t == 0.5);
  CHECK(hit->normal == near(1, 0, 0));
}

TEST_CASE("a ray along the axis of a cylinder meets its caps") {
  const double z = GENERATE(3.0, -2.0), away = z > 0 ? 1 : -1;
  const auto outside = meet(Cylinder{}, {0.5, 0.5, z}, {0, 0, -away});
  REQUIRE(outside);
  CHECK(outside->t == 2);
  CHECK(outside->normal == Vec3(0, 0, away));
  const auto inside = meet(Cylinder{}, {0.5, 0.5, 0.25}, {0, 0, away});
  REQUIRE(inside);
  CHECK(inside->t == (away > 0 ? 0.75 : 0.25));
  CHECK(inside->normal == Vec3(0, 0, away));
  CHECK_FALSE(meet(Cylinder{}, {1.5, 0, z}, {0, 0, -away}));
  CHECK_FALSE(meet(Cylinder{}, {0.5, 0.5, z}, {0, 0, away}));
}

TEST_CASE("the rim of a cap belongs to the cylinder") {
  CHECK(meet(Cylinder{}, {1, 0, 3}, {0, 0, -1})->t == 2);
  CHECK(meet(Cylinder{}, {0, -1, -2}, {0, 0, 1})->t == 2);
}

TEST_CASE("a slanting ray meets the cap it comes to first and leaves by the side") {
  // In at (0.5, 0, 1), on to (1, 0, 0.5).
  const auto in = meet(Cylinder{}, {-1.5, 0, 3}, {1, 0, -1});
  REQUIRE(in);
  CHECK(in->t == about(2 * std::sqrt(2)));
  CHECK(in->normal == Vec3(0, 0, 1));
  const auto out = meet(Cylinder{}, {0.5, 0, 1}, {1, 0, -1});
  REQUIRE(out);
  CHECK(out->t == about(0.5 * std::sqrt(2)));
  CHECK(out->normal == near(1, 0, 0));
}

TEST_CASE("where side and cap are met at the same distance the cap counts") {
  // Through the rim at (1, 0, 1), t = 1 for both without rounding; the direction is not of unit length.
  LocalHit hit;
  REQUIRE(Cylinder{}.intersect({{2, 0, 2}, {-1, 0, -1}}, hit));
  CHECK(hit.t == 1);
  CHECK(hit.normal == Vec3(0, 0, 1));
}

TEST_CASE("the side of a cylinder ends at z = 0 and z = 1, both included") {
  CHECK(meet(Cylinder{}, {5, 0, 0}, {-1, 0, 0})->t == 4);
  CHECK(meet(Cylinder{}, {5, 0, 1}, {-1, 0, 0})->t == 4);
  CHECK_FALSE(meet(Cylinder{}, {5, 0, -1e-15}, {-1, 0, 0}));
  CHECK_FALSE(meet(Cylinder{}, {5, 0, 1 + 1e-15}, {-1, 0, 0}));
}

TEST_CASE("a ray that grazes the side of a cylinder hits it") {
  // b^2 - 4ac = 100 - 4 * 25 = 0.
  const auto hit = meet(Cylinder{}, {1, 5, 0.5}, {0, -1, 0});
  REQUIRE(hit);
  CHECK(hit->t == 5);
  CHECK(hit->normal == near(1, 0, 0));
}

TEST_CASE("a cylinder behind the ray or beside it is missed, and so is the surface it leaves") {
  CHECK_FALSE(meet(Cylinder{}, {5, 0, 0.5}, {1, 0, 0}));
  CHECK_FALSE(meet(Cylinder{}, {5, 1.000001, 0.5}, {-1, 0, 0}));
  CHECK_FALSE(meet(Cylinder{}, {1, 0, 0.5}, {1, 0, 0}));
  CHECK_FALSE(meet(Cylinder{}, {0, 0, 1}, {0, 0, 1}));
  CHECK(meet(Cylinder{}, {1, 0, 0.5}, {-1, 0, 0})->t == 2);
  CHECK(meet(Cylinder{}, {0, 0, 1}, {0, 0, -1})->t == 1);
}
