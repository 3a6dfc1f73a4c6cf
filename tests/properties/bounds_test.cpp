// Boxes hold what they are the boxes of.
#include "geometry/bounds.hpp"

#include "geometry/box.hpp"
#include "geometry/cone.hpp"
#include "geometry/cylinder.hpp"
#include "geometry/sphere.hpp"
#include "geometry/square.hpp"
#include "tests/properties/generators.hpp"
#include "tests/properties/property.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

bool holds_point(const Bounds& bounds, const Vec3& p, const Vec3& slack) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(p[axis] >= bounds.min[axis] - slack[axis] && p[axis] <= bounds.max[axis] + slack[axis]))
      return false;
  }
  return true;
}

// Origins are at most 8 sqrt(3) away and hits less than 24: the point of a hit is within some roundings of
// 24, the surface within what primitives_test.cpp derives.
constexpr double slack_of_hits = 4096 * unit_roundoff;

template <class Shape>
void bounds_hold_hits(const Shape& shape) {
  holds([&] {
    const Ray ray = *aimed_ray();
    LocalHit hit;
    RC_PRE(shape.intersect(ray, hit));
    RC_ASSERT(holds_point(shape.bounds(), ray.at(hit.t), Vec3(slack_of_hits)));
  });
}

}  // namespace

TEST_CASE("the bounds of a primitive hold every hit") {
  SECTION("sphere") {
    bounds_hold_hits(Sphere{});
  }
  SECTION("box") {
    bounds_hold_hits(Box{});
  }
  SECTION("square") {
    bounds_hold_hits(Square{});
  }
  SECTION("cylinder") {
    bounds_hold_hits(Cylinder{});
  }
  SECTION("cone") {
    bounds_hold_hits(Cone(1, 0.5, 2, true));
  }
  SECTION("open cone") {
    bounds_hold_hits(Cone(0.25, 1.5, 1, false));
  }
}

TEST_CASE("transformed bounds hold the transformed points") {
  holds([] {
    Bounds bounds;
    bounds.add((*place()).at);
    bounds.add((*place()).at);
    const Mat4 matrix = (*transforms()).matrix();
    const Vec3 part = 0.5 + 0.5 * (*place_within()).at;
    const Vec3 inside = bounds.min + part * (bounds.max - bounds.min);
    const Vec3 moved(matrix * Vec4(inside, 1));
    // Seven roundings in each coordinate of a product of matrix and point, of terms no larger than these.
    Vec3 slack(0);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) slack[row] += std::abs(matrix[column][row]) * 8;
      slack[row] = 8 * unit_roundoff * (slack[row] + std::abs(matrix[3][row]));
    }
    RC_ASSERT(holds_point(transformed(bounds, matrix), moved, slack));
  });
}

TEST_CASE("transformed bounds are no larger than the transformed corners") {
  holds([] {
    Bounds bounds;
    bounds.add((*place()).at);
    bounds.add((*place()).at);
    const Transforms given = *transforms();
    const Mat4 matrix = given.matrix();
    const Bounds moved = transformed(bounds, matrix);
    Bounds corners;
    for (int corner = 0; corner < 8; ++corner) {
      corners.add(Vec3(matrix * Vec4(corner & 1 ? bounds.max.x : bounds.min.x,
                                     corner & 2 ? bounds.max.y : bounds.min.y,
                                     corner & 4 ? bounds.max.z : bounds.min.z, 1)));
    }
    // Scales are at most 8 and coordinates 8: terms of at most 64, three and a translation.
    const Vec3 slack(8 * unit_roundoff * (3 * 64 * std::sqrt(3.0) + 8));
    RC_ASSERT(holds_point(corners, moved.min, slack));
    RC_ASSERT(holds_point(corners, moved.max, slack));
  });
}
