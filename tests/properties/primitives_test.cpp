// What holds of every ray and every primitive, in the space of the primitive.
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

// How far a point is from the surface (>= 0), up to a factor of at most 2 near it. Rounds by some units of
// 1 + p.p.
double distance(const Sphere&, const Vec3& p) {
  return std::abs(glm::dot(p, p) - 1);
}
double distance(const Box&, const Vec3& p) {
  return std::abs(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.5);
}
double distance(const Square&, const Vec3& p) {
  return std::max({std::abs(p.z), std::abs(p.x) - 0.5, std::abs(p.y) - 0.5});
}
double distance(const Cylinder&, const Vec3& p) {
  return std::abs(std::max({p.x * p.x + p.y * p.y - 1, p.z - 1, -p.z}));
}

// Of a point inside a convex solid: how deep it is, negative outside; as coarse as distance().
double depth(const Sphere&, const Vec3& p) {
  return 1 - glm::dot(p, p);
}
double depth(const Box&, const Vec3& p) {
  return 0.5 - std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}
double depth(const Cylinder&, const Vec3& p) {
  return -std::max({p.x * p.x + p.y * p.y - 1, p.z - 1, -p.z});
}

// Coordinates of origins are at most 8, so o.o <= 192 and a hit is at most 8 sqrt(3) + 2 < 16 away. The
// quadratic's coefficients c and b^2/4a are at most 192 and each takes fewer than 8 roundings; the point
// o + t d adds two of at most 16 a coordinate, times a gradient of 2: below 4096 u in all, which is 4.5e-13.
constexpr double on_surface = 4096 * unit_roundoff;

template <class Shape>
void hit_is_on_surface(const Shape& shape) {
  holds([&] {
    const Ray ray = *aimed_ray();
    LocalHit hit;
    RC_PRE(shape.intersect(ray, hit));
    RC_TAG(glm::dot(hit.normal, ray.direction) > 0);
    RC_ASSERT(hit.t >= 0);
    RC_ASSERT(distance(shape, ray.at(hit.t)) <= on_surface);
  });
}

// A place inside the shape: a place of the unit cube, moved and shrunk into it.
Vec3 inside(const Sphere&, const Vec3& p) {
  return 0.5 * p;
}
Vec3 inside(const Box&, const Vec3& p) {
  return 0.5 * p;
}
Vec3 inside(const Cylinder&, const Vec3& p) {
  return {0.6 * p.x, 0.6 * p.y, 0.5 + 0.5 * p.z};
}

template <class Shape>
void nothing_is_nearer(const Shape& shape) {
  holds([&] {
    const Ray ray = *aimed_ray();
    LocalHit hit;
    RC_PRE(shape.intersect(ray, hit));
    RC_PRE(depth(shape, ray.origin) < 0);
    const double part = *rc::gen::inRange(0, 1024) / 1024.0;
    RC_ASSERT(depth(shape, ray.at(part * hit.t)) <= on_surface);
  });
}

template <class Shape>
void both_ends_see_it(const Shape& shape) {
  holds([&] {
    const Vec3 within = inside(shape, (*place_within()).at);
    const Vec3 along = (*heading()).along;
    const double away = *rc::gen::inRange(4, 1000);
    LocalHit there, back;
    RC_ASSERT(shape.intersect({within - away * along, along}, there));
    RC_ASSERT(shape.intersect({within + away * along, -along}, back));
    // What is between the two hits is the chord, and `within` is on it.
    const double slack = 16 * unit_roundoff * away * away;
    RC_ASSERT(there.t <= away + slack);
    RC_ASSERT(back.t <= away + slack);
    RC_ASSERT(glm::dot(there.normal, along) <= slack);
    RC_ASSERT(glm::dot(back.normal, -along) <= slack);
  });
}

template <class Shape>
void inside_is_closed(const Shape& shape) {
  holds([&] {
    const Vec3 within = inside(shape, (*place_within()).at);
    const Vec3 along = (*heading()).along;
    LocalHit hit;
    RC_ASSERT(shape.intersect({within, along}, hit));
    RC_ASSERT(glm::dot(hit.normal, along) > 0);
  });
}

}  // namespace

TEST_CASE("every hit lies on the surface of its primitive") {
  SECTION("sphere") {
    hit_is_on_surface(Sphere{});
  }
  SECTION("box") {
    hit_is_on_surface(Box{});
  }
  SECTION("square") {
    hit_is_on_surface(Square{});
  }
  SECTION("cylinder") {
    hit_is_on_surface(Cylinder{});
  }
}

TEST_CASE("no point of a convex solid is nearer on the ray than its hit") {
  SECTION("sphere") {
    nothing_is_nearer(Sphere{});
  }
  SECTION("box") {
    nothing_is_nearer(Box{});
  }
  SECTION("cylinder") {
    nothing_is_nearer(Cylinder{});
  }
}

TEST_CASE("a ray reversed from beyond a convex solid hits it too") {
  SECTION("sphere") {
    both_ends_see_it(Sphere{});
  }
  SECTION("box") {
    both_ends_see_it(Box{});
  }
  SECTION("cylinder") {
    both_ends_see_it(Cylinder{});
  }
}

TEST_CASE("every ray from inside a convex solid leaves through its surface") {
  SECTION("sphere") {
    inside_is_closed(Sphere{});
  }
  SECTION("box") {
    inside_is_closed(Box{});
  }
  SECTION("cylinder") {
    inside_is_closed(Cylinder{});
  }
}

TEST_CASE("a hit of a cone lies between its ends") {
  holds([] {
    const double bottom = *coordinate(), top = *coordinate(), height = 0.25 + std::abs(*coordinate());
    const Cone cone(bottom, top, height, *rc::gen::arbitrary<bool>());
    const Ray ray = *aimed_ray();
    LocalHit hit;
    RC_PRE(cone.intersect(ray, hit));
    const Bounds bounds = cone.bounds();
    const Vec3 p = ray.at(hit.t);
    // A hit's point is off by two roundings of a coordinate on the way to it.
    const double slack = 4 * unit_roundoff * (hit.t + 16);
    RC_ASSERT(p.z >= bounds.min.z - slack);
    RC_ASSERT(p.z <= bounds.max.z + slack);
    RC_ASSERT(std::abs(glm::length(hit.normal) - 1) <= 4 * unit_roundoff);
  });
}
