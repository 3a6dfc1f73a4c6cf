// What holds of every ray and every triangle, as decided by the fast test where it is certain and else
// exactly.
#include "geometry/triangle.hpp"
#include "tests/properties/generators.hpp"
#include "tests/properties/property.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

struct Points {
  Vec3 at[3];

  double longest() const {
    return std::max({glm::length(at[1] - at[0]), glm::length(at[2] - at[1]), glm::length(at[0] - at[2])});
  }
  Vec3 area() const { return glm::cross(at[1] - at[0], at[2] - at[0]); }
};

Points corners() {
  return {{(*place()).at, (*place()).at, (*place()).at}};
}

// The face (first, first + 1, first + 2) of the points, or the other way round.
bool meets(const Points& points, std::uint32_t first, bool reversed, const Ray& ray, TriangleHit& hit) {
  const std::uint32_t next = (first + 1) % 3, last = (first + 2) % 3;
  const Corners corners{points.at[first], points.at[reversed ? last : next],
                        points.at[reversed ? next : last]};
  if (trace::meets(Triangle(corners), ray, hit) == Meeting::none) return false;
  return crosses_exactly(corners, ray, hit);
}

// A ray at a place of the triangle's plane: inside, on an edge or a corner, or beside it.
Ray aimed(const Points& corners) {
  const double u = *rc::gen::inRange(0, 9) / 8.0, v = *rc::gen::inRange(0, 9) / 8.0;
  const Vec3 target =
      corners.at[0] + u * (corners.at[1] - corners.at[0]) + v * (corners.at[2] - corners.at[0]);
  const Vec3 origin = (*place()).at;
  RC_PRE(origin != target);
  return {origin, glm::normalize(target - origin)};
}

// t is a quotient of determinants of the corners seen from the origin; their rounding is some u of the
// product of the lengths that go in, and dividing by det leaves this bound (16 covers the operations).
double t_bound(const Points& corners, const Ray& ray, double t) {
  const double longest = corners.longest();
  const double reach =
      std::max({glm::length(corners.at[0] - ray.origin), glm::length(corners.at[1] - ray.origin),
                glm::length(corners.at[2] - ray.origin), t});
  return 16 * unit_roundoff * longest * longest * reach / std::abs(glm::dot(corners.area(), ray.direction));
}

}  // namespace

TEST_CASE("a triangle is hit or missed whichever corner comes first") {
  holds([] {
    const Points given = corners();
    const Ray ray = aimed(given);
    TriangleHit hits[3];
    const bool hit = meets(given, 0, false, ray, hits[0]);
    RC_ASSERT(meets(given, 1, false, ray, hits[1]) == hit);
    RC_ASSERT(meets(given, 2, false, ray, hits[2]) == hit);
    RC_PRE(hit);
    const double bound = t_bound(given, ray, hits[0].t);
    RC_ASSERT(std::abs(hits[1].t - hits[0].t) <= bound);
    RC_ASSERT(std::abs(hits[2].t - hits[0].t) <= bound);
  });
}

TEST_CASE("a triangle is hit or missed whichever way round its corners go") {
  holds([] {
    const Points given = corners();
    const Ray ray = aimed(given);
    TriangleHit front, back;
    const bool hit = meets(given, 0, false, ray, front);
    RC_ASSERT(meets(given, 0, true, ray, back) == hit);
    RC_PRE(hit);
    RC_ASSERT(std::abs(front.t - back.t) <= t_bound(given, ray, front.t));
  });
}

TEST_CASE("the weights of a hit are those of its point in the triangle") {
  holds([] {
    const Points given = corners();
    const Ray ray = aimed(given);
    TriangleHit hit;
    RC_PRE(meets(given, 0, false, ray, hit));
    // Not for rays in the plane, where a weight says nothing.
    const double bound = t_bound(given, ray, hit.t);
    RC_PRE(bound < 1e-6);
    const Vec3 point =
        given.at[0] + hit.u * (given.at[1] - given.at[0]) + hit.v * (given.at[2] - given.at[0]);
    RC_ASSERT(hit.u >= -unit_roundoff);
    RC_ASSERT(hit.v >= -unit_roundoff);
    RC_ASSERT(hit.u + hit.v <= 1 + 4 * unit_roundoff);
    // Each weight is a quotient as t is, of the same determinant.
    RC_ASSERT(glm::length(point - ray.at(hit.t)) <= 8 * bound + 64 * unit_roundoff * 16);
  });
}

TEST_CASE("no ray passes between two triangles that share an edge") {
  holds(
      [] {
        const Points given = corners();
        const Vec3 opposite = (*place()).at;
        const Points other{{given.at[1], given.at[0], opposite}};
        RC_PRE(!is_zero(given.area()) && !is_zero(other.area()));
        // At a place of the shared edge, from where the two do not hide each other: the third corners are on
        // either side of the plane of the ray and the edge.
        const double along = *rc::gen::inRange(1, 1024) / 1024.0;
        const Vec3 target = given.at[0] + along * (given.at[1] - given.at[0]);
        const Vec3 origin = (*place()).at;
        RC_PRE(origin != target);
        const Ray ray{origin, glm::normalize(target - origin)};
        const Vec3 plane = glm::cross(given.at[1] - given.at[0], ray.direction);
        const double here = glm::dot(plane, given.at[2] - target), there = glm::dot(plane, opposite - target);
        RC_PRE(here * there < 0 && std::min(std::abs(here), std::abs(there)) > 1e-6);
        TriangleHit hit;
        RC_ASSERT(meets(given, 0, false, ray, hit) || meets(other, 0, false, ray, hit));
      },
      2000);
}
