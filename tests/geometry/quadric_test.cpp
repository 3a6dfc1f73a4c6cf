#include "geometry/quadric.hpp"

#include "geometry/sphere.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/quad.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Quadric::Coefficients ball{1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
const Quadric::Coefficients one_sheet{1, 1, -1, 0, 0, 0, 0, 0, 0, -1};
const Quadric::Coefficients two_sheets{1, -1, -1, 0, 0, 0, 0, 0, 0, -1};
const Quadric::Coefficients saddle{1, -1, 0, 0, 0, 0, 0, 0, -1, 0};
const Quadric::Coefficients cone_pair{1, 1, -1, 0, 0, 0, 0, 0, 0, 0};
const Quadric::Coefficients leaning{2, 3, 1, 0.5, -1, 0.25, 1, -2, 0.5, -4};

struct Exact {
  Quad value, slope;  // q and the length of its gradient

  Exact(const Quadric::Coefficients& k, const Ray& ray, double t) {
    const Quad x = Quad(ray.origin.x) + Quad(t) * ray.direction.x;
    const Quad y = Quad(ray.origin.y) + Quad(t) * ray.direction.y;
    const Quad z = Quad(ray.origin.z) + Quad(t) * ray.direction.z;
    value = k[0] * x * x + k[1] * y * y + k[2] * z * z + k[3] * x * y + k[4] * x * z + k[5] * y * z +
            k[6] * x + k[7] * y + k[8] * z + k[9];
    const Quad gx = 2 * k[0] * x + k[3] * y + k[4] * z + k[6], gy = 2 * k[1] * y + k[3] * x + k[5] * z + k[7],
               gz = 2 * k[2] * z + k[4] * x + k[5] * y + k[8];
    slope = root(gx * gx + gy * gy + gz * gz);
  }
};

}  // namespace

TEST_CASE(
    "a quadric with a sphere's coefficients is hit where the sphere is, at either side of the surface") {
  Random random(1);
  const Quadric quadric(ball);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 origin = random.in_cube(3);
    const Ray ray{origin, glm::normalize(random.in_cube(1.2) - origin)};
    LocalHit expected, found;
    const bool hit = Sphere{}.intersect(ray, expected);
    REQUIRE(quadric.intersect(ray, found) == hit);
    if (!hit) continue;
    ++hits;
    CHECK(std::abs(found.t - expected.t) < 1e-9);  // the sphere's own forms have 2^-35
    const double facing = glm::dot(expected.normal, ray.direction) > 0 ? -1 : 1;
    CHECK(found.normal == near(facing * expected.normal, 1e-9));
  }
  CHECK(hits > 1000);
}

TEST_CASE(
    "the place of a hit is on the quadric within 32 units in the last place of its coordinates and of t") {
  Random random(2);
  int hits = 0;
  for (const auto& k : {ball, one_sheet, two_sheets, saddle, leaning}) {
    const Quadric quadric(k);
    for (int i = 0; i < 3000; ++i) {
      const double away = std::pow(10.0, random.between(0, 8));
      const Vec3 target = random.in_cube(2);
      const Vec3 origin = target + away * glm::normalize(random.in_cube(1) + Vec3(0, 0, 1e-3));
      const Ray ray{origin, glm::normalize(target - origin)};
      LocalHit hit;
      if (!quadric.intersect(ray, hit)) continue;
      ++hits;
      const Exact exact(k, ray, hit.t);
      const double size = largest(ray.at(hit.t)) + hit.t;
      CHECK(magnitude(exact.value) <= Quad(32 * 0x1p-53 * (1 + size)) * (exact.slope + Quad(0x1p-26)));
    }
  }
  CHECK(hits > 4000);
}

TEST_CASE("a hit and a miss of a quadric are told apart from 1e8 away") {
  const Quadric quadric(one_sheet);  // the waist is the unit circle
  const double beside = GENERATE(1e-6, 1e-9, 1e-12);
  LocalHit hit;
  const Ray inside{{1 - beside, 1e8, 0}, {0, -1, 0}}, outside{{1 + beside, 1e8, 0}, {0, -1, 0}};
  CHECK(quadric.intersect(inside, hit));
  CHECK_FALSE(quadric.intersect(outside, hit));
}

TEST_CASE("a ray that leaves a quadric meets its other sheet or side, not the place it leaves") {
  const double error = GENERATE(0.0, 1e-15, 1e-9);
  LocalHit hit;
  for (const double off : {0.0, error, -error}) {
    REQUIRE(Quadric(two_sheets).intersect({{1 + off, 0, 0}, {-1, 0, 0}, error}, hit));
    CHECK(hit.t == about(2 + off));
    CHECK_FALSE(Quadric(two_sheets).intersect({{1 + off, 0, 0}, {1, 0, 0}, error}, hit));
    REQUIRE(Quadric(ball).intersect({{1 + off, 0, 0}, {-1, 0, 0}, error}, hit));
    CHECK(hit.t == about(2 + off));
  }
}

TEST_CASE("a saddle is hit along the lines where its equation is linear") {
  // z = x^2 - y^2 along x = y + 1: 2 y + 1.
  const auto hit = meet(Quadric(saddle), {11, 10, 5}, {-1, -1, 0});
  REQUIRE(hit);
  CHECK(hit->t == about(8 * std::sqrt(2.0)));
  // Down, where there is one place.
  const auto down = meet(Quadric(saddle), {3, 2, 50}, {0, 0, -1});
  REQUIRE(down);
  CHECK(down->t == about(45));
  // In the line itself there is none.
  CHECK_FALSE(meet(Quadric(saddle), {2, 2, 0}, {1, 1, 0}));
}

TEST_CASE("a ray at the apex of a quadric cone hits it") {
  const auto hit = meet(Quadric(cone_pair), {0, 0, 5}, {0, 0, -1});
  REQUIRE(hit);
  CHECK(hit->t == about(5));
  CHECK(hit->normal == near(0, 0, 1));
}

TEST_CASE("a quadric exists within its limits only") {
  Bounds limits = Bounds::everything();
  limits.min.z = -1;
  limits.max.z = 2;
  const Quadric tube({1, 1, 0, 0, 0, 0, 0, 0, 0, -1}, limits, {Vec3(-1, -1, -1), Vec3(1, 1, 2)});
  CHECK(meet(tube, {5, 0, 2}, {-1, 0, 0}));
  CHECK_FALSE(meet(tube, {5, 0, 2.001}, {-1, 0, 0}));
  CHECK_FALSE(meet(tube, {5, 0, -1.001}, {-1, 0, 0}));
  // Over the rim, in at the far side.
  const auto far_side = meet(tube, {3, 0, 4}, {-1, 0, -0.75});
  REQUIRE(far_side);
  CHECK(far_side->normal == near(1, 0, 0));
}

TEST_CASE("a quadric is the same however its coefficients are scaled") {
  Quadric::Coefficients scaled = leaning;
  const double s = GENERATE(1e-200, -1.0, 1e150);
  for (double& x : scaled) x *= s;
  const auto hit = meet(Quadric(scaled), {5, 4, 3}, {-5, -4, -3});
  const auto expected = meet(Quadric(leaning), {5, 4, 3}, {-5, -4, -3});
  REQUIRE((hit && expected));
  CHECK(hit->t == about(expected->t));
  CHECK(hit->normal == near(expected->normal));
}

TEST_CASE("the distance from a quadric is never less than the real one next to it") {
  const double off = GENERATE(0.0, 1e-15, 1e-9, 1e-4);
  const Quadric quadric(ball);
  CHECK(quadric.distance(Vec3(0, 0, 1 + off), {}) >= off);
  CHECK(quadric.distance(Vec3(0, 0, 1 + off), {}) <= 1.01 * off + 1e-14);
  // At the apex of a cone it is measured along no gradient.
  CHECK(Quadric(cone_pair).distance(Vec3(0, 0, off), {}) >= off / std::sqrt(2.0));
}
