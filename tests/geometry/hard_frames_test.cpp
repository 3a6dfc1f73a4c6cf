// Places where doubles get hard: tiny, huge, flat, mirrored, far away.
#include "geometry/frame.hpp"
#include "geometry/normal_matrix.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/quad_matrix.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Frame frame_scaled(const Vec3& factors) {
  return Frame(Placement().inside(scaling(factors)));
}

// n_i / s_i, of unit length: what the inverse transpose of a scale makes of a normal.
Vec3 normal_under_scale(const Vec3& n, const Vec3& s) {
  const Quad x = Quad(n.x) / s.x, y = Quad(n.y) / s.y, z = Quad(n.z) / s.z;
  Quad most = std::max({magnitude(x), magnitude(y), magnitude(z)});
  const Quad a = x / most, b = y / most, c = z / most;
  const Quad length = root(a * a + b * b + c * c);
  return {double(a / length), double(b / length), double(c / length)};
}

}  // namespace

TEST_CASE("normals are right at every scale, and outward under every mirror") {
  const Vec3 n = glm::normalize(Vec3(1, -2, 3));
  for (const double size : {1e-300, 1e-160, 1e-110, 1e-16, 1.0, 1e16, 1e110, 1e160, 1e300}) {
    for (const Vec3& s : {Vec3(1, 2, 4), Vec3(-1, 2, 4), Vec3(-1, -2, 4), Vec3(-1, -2, -4)}) {
      INFO(size << " " << s.x);
      const Vec3 factors = size * s;
      CHECK(frame_scaled(factors).world_normal(n) == near(normal_under_scale(n, factors), 1e-15));
    }
  }
}

TEST_CASE("factors of any ratio leave normals of unit length") {
  const Frame frame = frame_scaled({1e-170, 1, 1e170});  // the cofactors are 340 decades apart
  CHECK(frame.world_normal({1, 0, 0}) == near(1, 0, 0));
  CHECK(frame.world_normal({0, 1, 0}) == near(0, 1, 0));
  CHECK(frame.world_normal({0, 0, 1}) == near(0, 0, 1));
  CHECK(frame.world_normal({0, 0.6, 0.8}) == near(0, 1, 0));
}

TEST_CASE("what is flat has the normal of its plane") {
  Mat4 flat(1);
  flat[2][2] = 0;
  const Mat3 to_world = normal_matrix(rotation({1, 0, 0}, std::acos(-1.0) / 2).matrix * flat);
  const Vec3 n = unit_vector(to_world * Vec3(0.6, 0, 0.8)).direction;
  CHECK(n == near(0, -1, 0));  // the z axis turned
}

TEST_CASE("a place of 1e-110 has an inverse, which the determinant has not") {
  for (const double size : {1e-300, 1e-110, 1e-90}) {
    const Frame frame(Placement()
                          .inside(translation(Vec3(size, 0, 0)))
                          .inside(rotation({0, 0, 1}, std::acos(-1.0) / 2))
                          .inside(scaling(Vec3(size))));
    REQUIRE(frame.invertible());
    CHECK(Vec3(frame.to_object * Vec4(size, size, 0, 1)) == near(1, 0, 0));
    const ObjectRay ray(frame, {{0, 0, size}, {0, 0, -1}});
    CHECK(ray.ray.direction == near(0, 0, -1));
    CHECK(ray.ray.origin == near(0, 1, 1));
    CHECK(ray.scale == Approx(1 / size));
  }
}

TEST_CASE("a disc 1e-17 thin keeps the thickness that its matrix has lost") {
  const Vec3 axis(1, 2, 3);
  const Frame frame(Placement()
                        .inside(rotation(axis, 0.7))
                        .inside(scaling({1, 1, 1e-17}))
                        .inside(rotation({3, 1, 0}, 0.4)));
  REQUIRE(frame.invertible());
  // A ray down the turned z axis from 2 above: in the unscaled space 2e17 away along the turned axis.
  const Vec3 z(rotation(axis, 0.7).matrix * Vec4(0, 0, 1, 0));
  const ObjectRay ray(frame, {2.0 * z, -z});
  CHECK(ray.scale == Approx(1e17).epsilon(1e-9));
}

TEST_CASE("a place is singular only where nothing can be saved") {
  CHECK_FALSE(frame_scaled({1, 1, 0}).invertible());
  CHECK_FALSE(frame_scaled({1e-309, 1, 1}).invertible());  // 1 / 1e-309 is infinite
  CHECK_FALSE(Frame(Placement().inside(scaling(Vec3(1e200))).inside(scaling(Vec3(1e200)))).invertible());
  CHECK_FALSE(Frame(Placement().inside(scaling(Vec3(1e-200))).inside(scaling(Vec3(1e-200)))).invertible());
  CHECK_FALSE(Frame(Placement().inside(rotation(Vec3(0), 1))).invertible());
  CHECK(frame_scaled({1e-300, 1e300, 1}).invertible());
}

TEST_CASE("the direction of a ray from far away does not suffer from its origin") {
  const Frame frame(Placement().inside(translation({1e12, -1e12, 3e12})).inside(scaling(Vec3(2))));
  const Vec3 d = glm::normalize(Vec3(1, 2, -3));
  for (const Vec3& from : {Vec3(1e12, -1e12, 3e12), Vec3(7e15, 0, 0), Vec3(1e300, 1e200, 0)}) {
    const ObjectRay ray(frame, {from, d});
    CHECK(ray.ray.direction == near(d, 1e-15));
    CHECK(ray.scale == Approx(0.5).epsilon(1e-15));
  }
}

TEST_CASE("the direction of an ordinary ray has the bits of the difference of two points") {
  const Frame frame(Placement().inside(rotation({1, 2, 3}, 1)).inside(scaling({1.1, 2.3, 0.7})));
  for (int i = 0; i < 100; ++i) {
    const Vec3 from(3.1 + i, -7.7, 0.3 * i), d = glm::normalize(Vec3(-3, i, 1));
    const Vec3 along = Vec3(frame.to_object * Vec4(from + d, 1)) - Vec3(frame.to_object * Vec4(from, 1));
    CHECK(ObjectRay(frame, {from, d}).ray.direction == glm::normalize(along));
    CHECK(ObjectRay(frame, {from, d}).scale == glm::length(along));
  }
}

TEST_CASE("length and direction of vectors whose squares are out of range") {
  CHECK(unit_vector({3e-200, 0, 4e-200}).length == Approx(5e-200).epsilon(1e-15));
  CHECK(unit_vector({3e200, 0, -4e200}).direction == near(0.6, 0, -0.8, 1e-15));
  CHECK(unit_vector({5e-324, 0, 0}).direction == Vec3(1, 0, 0));
  CHECK(unit_vector({0, 0, -1.7e308}).direction == Vec3(0, 0, -1));
  CHECK(std::isnan(unit_vector({0, 0, 0}).direction.x));
}
