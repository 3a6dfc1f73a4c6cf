// Rays through the rim of a cylinder, which rounding can put beside both the side and the cap.
#include "geometry/cylinder.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/quad.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Vec3 on_rim(Random& random, double z) {
  const double angle = random.between(0, 6.283);
  return {std::cos(angle), std::sin(angle), z};
}

// From outside through the rim of one cap to a point within the other.
Ray through_rim(Random& random) {
  const double z = random.below(2);
  const Vec3 in = on_rim(random, z);
  const double within = random.between(0, 0.9);
  const Vec3 out = within * on_rim(random, 0) + Vec3(0, 0, 1 - z);
  const double distance = random.between(0.1, 20);
  return {in + distance * glm::normalize(in - out), glm::normalize(out - in)};
}

// Where the exact ray comes into the cylinder: when it is past both the side and the cap.
Quad entry(const Ray& ray) {
  const Quad ox = ray.origin.x, oy = ray.origin.y, dx = ray.direction.x, dy = ray.direction.y;
  const Quad a = dx * dx + dy * dy, b = ox * dx + oy * dy, c = ox * ox + oy * oy - 1;
  const Quad side = (-b - root(b * b - a * c)) / a;
  const Quad cap = ((ray.direction.z > 0 ? 0 : 1) - Quad(ray.origin.z)) / ray.direction.z;
  return side > cap ? side : cap;
}

}  // namespace

TEST_CASE(
    "a ray through the rim of a cylinder meets it there, also where rounding puts it beside side and cap") {
  Random random(4);
  int missed = 0, wrong = 0, gaps = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Ray ray = through_rim(random);
    LocalHit hit;
    if (!Cylinder{}.intersect(ray, hit)) {
      ++missed;
      continue;
    }
    if (!(magnitude(hit.t - entry(ray)) < Quad(1e-12)) || glm::dot(hit.normal, ray.direction) > 0) ++wrong;
    if (hit.is_gap) ++gaps;
  }
  CHECK(missed == 0);
  CHECK(wrong == 0);
  CHECK(gaps > 0);
}

TEST_CASE("a ray past the rim of a cylinder misses it") {
  LocalHit hit;
  const double beside = GENERATE(1e-15, 1e-9, 1e-3);
  // On the line x + z = 2 + beside, past the rim at (1, 0, 1).
  CHECK_FALSE(Cylinder{}.intersect({{3, 0, beside - 1}, glm::normalize(Vec3(-1, 0, 1))}, hit));
  CHECK_FALSE(Cylinder{}.intersect({{1 + beside, 0, 5}, {0, 0, -1}}, hit));
}
