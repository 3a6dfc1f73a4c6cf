// Spaces of objects: there and back, rays and normals.
#include "geometry/frame.hpp"

#include "tests/properties/generators.hpp"
#include "tests/properties/property.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// The largest term in a product of a placement and its inverse with a point: scales and their inverses are
// at most 8 and coordinates 8, so a point has at most 8 * 8 sqrt(3) + 8 < 120 and goes back through factors
// of 8. 64 roundings of that cover building the inverse.
constexpr double there_and_back = 64 * unit_roundoff * 8 * 120;

}  // namespace

TEST_CASE("a point into a space and back is the point") {
  holds([] {
    const Frame frame((*transforms()).matrix());
    const Vec3 p = (*place()).at;
    const Vec3 there(frame.to_world * Vec4(p, 1));
    RC_ASSERT(glm::length(Vec3(frame.to_object * Vec4(there, 1)) - p) <= there_and_back);
    const Vec3 here(frame.to_object * Vec4(p, 1));
    RC_ASSERT(glm::length(Vec3(frame.to_world * Vec4(here, 1)) - p) <= there_and_back * 8);
  });
}

TEST_CASE("a ray in the space of an object passes through the same points at t times its scale") {
  holds([] {
    const Frame frame((*transforms()).matrix());
    const Ray world{(*place()).at, (*heading()).along};
    const ObjectRay object(frame, world);
    RC_ASSERT(std::abs(glm::length(object.ray.direction) - 1) <= 4 * unit_roundoff);
    const double t = *rc::gen::inRange(0, 64) * 0.25;
    const Vec3 through_world(frame.to_object * Vec4(world.at(t), 1));
    RC_ASSERT(glm::length(object.ray.at(t * object.scale) - through_world) <= 16 * there_and_back);
  });
}

TEST_CASE("a normal stays across every tangent and on its side, mirrored or not") {
  holds([] {
    const Frame frame((*transforms()).matrix());
    const Vec3 normal = (*heading()).along;
    const Vec3 tangent = glm::cross(normal, (*heading()).along);
    const Mat3 linear(frame.to_world);
    const Vec3 moved = frame.world_normal(normal);
    RC_ASSERT(std::abs(glm::length(moved) - 1) <= 4 * unit_roundoff);
    // Scales differ by at most 64, and so do the lengths of the terms that cancel.
    RC_ASSERT(std::abs(glm::dot(moved, linear * tangent)) <= 64 * 64 * unit_roundoff);
    RC_ASSERT(glm::dot(moved, linear * normal) > 0);
  });
}
