#include "geometry/torus.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a torus is met at its outer circle, then across the hole at its inner one") {
  const Torus torus(1, 0.25);
  const auto outside = meet(torus, {5, 0, 0}, {-1, 0, 0});
  REQUIRE(outside);
  CHECK(outside->t == about(3.75));
  CHECK(outside->normal == near(1, 0, 0));
  const auto from_hole = meet(torus, {0, 0, 0}, {-1, 0, 0});
  REQUIRE(from_hole);
  CHECK(from_hole->t == about(0.75));
  CHECK(from_hole->normal == near(1, 0, 0));
}

TEST_CASE("a ray along the axis passes through the hole of a torus") {
  const Torus torus(1, 0.25);
  CHECK_FALSE(meet(torus, {0, 0, 5}, {0, 0, -1}));
  CHECK_FALSE(meet(torus, {0.7, 0, 5}, {0, 0, -1}));
  const auto top = meet(torus, {0, 1, 5}, {0, 0, -1});
  REQUIRE(top);
  CHECK(top->t == about(4.75));
  CHECK(top->normal == near(0, 0, 1));
}

TEST_CASE("a torus is left at its far side from inside the tube, with the normal still outward") {
  const auto hit = meet(Torus(2, 0.5), {2, 0, 0}, {0, 0, -1});
  REQUIRE(hit);
  CHECK(hit->t == about(0.5));
  CHECK(hit->normal == near(0, 0, -1));
}

TEST_CASE(
    "a ray that leaves a torus outward meets what is across the hole, inward the other side of the tube") {
  const Torus torus(1, 0.25);
  LocalHit hit;
  const double error = GENERATE(0.0, 1e-15, 1e-10);
  for (const double off : {0.0, error, -error}) {
    REQUIRE(torus.intersect({{0.75 + off, 0, 0}, {-1, 0, 0}, error, 4 * error}, hit));
    CHECK(hit.t == about(1.5 + off));
    REQUIRE(torus.intersect({{0.75 + off, 0, 0}, {1, 0, 0}, error, 4 * error}, hit));
    CHECK(hit.t == about(0.5 - off));
    CHECK_FALSE(torus.intersect({{1.25 + off, 0, 0}, {1, 0, 0}, error, 4 * error}, hit));
  }
}

TEST_CASE("a ray that leaves a torus never meets the place it leaves") {
  Random random(3);
  for (const Torus& torus : {Torus(1, 0.2), Torus(1, 1), Torus(1, 1.5), Torus(20, 0.01)}) {
    int left = 0, again = 0;
    while (left < 2000) {
      const Vec3 target = 1.0 * random.in_cube(torus.major() + torus.minor());
      const auto from = meet(torus, {3 * torus.major(), 4 * torus.major(), 5 * torus.major()},
                             target - torus.major() * Vec3(3, 4, 5));
      if (!from) continue;
      ++left;
      const Ray first = ray(torus.major() * Vec3(3, 4, 5), target - torus.major() * Vec3(3, 4, 5));
      const Vec3 p = first.at(from->t);
      const double height = torus.distance(p, from->normal) + gamma(4) * (1 + largest(p));
      const Vec3 direction = glm::normalize(random.in_cube(1) + Vec3(0, 0, 1e-3));
      const double cosine = std::abs(glm::dot(direction, from->normal));
      if (cosine < 1e-6) continue;
      LocalHit hit;
      if (torus.intersect({p, direction, height, 4 * height / cosine}, hit) && hit.t < 1e-9 * torus.major()) {
        ++again;
      }
    }
    CHECK(again == 0);
  }
}

TEST_CASE("a horn torus closes at the centre, a spindle torus is dimpled there and has nothing inside") {
  const auto horn = meet(Torus(1, 1), {0.5, 0, 5}, {0, 0, -1});
  REQUIRE(horn);
  CHECK(horn->t == about(5 - std::sqrt(0.75)));
  // Spheres of radius 2 with centres on the unit circle: at the axis they reach up to sqrt(3).
  const auto spindle = meet(Torus(1, 2), {0, 0, 5}, {0, 0, -1});
  REQUIRE(spindle);
  CHECK(spindle->t == about(5 - std::sqrt(3.0)));
  // From the centre, which is inside the solid, out at the far side: the lemon does not count.
  const auto out = meet(Torus(1, 2), {0, 0, 0}, {1, 0, 0});
  REQUIRE(out);
  CHECK(out->t == about(3));
}

TEST_CASE("a torus is hit alike at every scale") {
  const double s = GENERATE(1e-200, 1e-30, 1e-3, 1e5, 1e30, 1e200);
  LocalHit hit;
  REQUIRE(Torus(s, 0.25 * s).intersect({{5 * s, 0, 0}, {-1, 0, 0}}, hit));
  CHECK(hit.t / s == about(3.75));
  CHECK_FALSE(Torus(s, 0.25 * s).intersect({{0, 0, 5 * s}, {0, 0, -1}}, hit));
}

TEST_CASE("a ray without a place or a direction meets no torus") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  LocalHit hit;
  CHECK_FALSE(Torus(1, 0.5).intersect({Vec3(nan), Vec3(0, 0, 1)}, hit));
  CHECK_FALSE(Torus(1, 0.5).intersect({Vec3(0), Vec3(nan)}, hit));
  CHECK_FALSE(Torus(1, 0.5).intersect({Vec3(infinity), Vec3(0, 0, -1)}, hit));
  CHECK_FALSE(Torus(1, 0.5).intersect({Vec3(1e300), glm::normalize(Vec3(1))}, hit));
}
