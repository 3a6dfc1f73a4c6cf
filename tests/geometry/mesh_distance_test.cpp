#include "geometry/mesh.hpp"
#include "tests/hard/quad.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;
using trace::hard::QuadVec;

namespace {

// Of a point from the plane of the first face, to some 30 digits.
double true_distance(const Mesh& mesh, const Vec3& p) {
  const Corners c = mesh.corners(0);
  const QuadVec a(c.a), normal = cross(QuadVec(c.b) - a, QuadVec(c.c) - a);
  return static_cast<double>(magnitude(dot(QuadVec(p) - a, normal)) / length(normal));
}

Mesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  Mesh mesh;
  mesh.points = {a, b, c};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE(
    "the distance of a point from the plane of a face, to either side, as far beside the face as it is") {
  const Mesh mesh = triangle({0, 0, 1}, {2, 0, 1}, {0, 2, 1});
  const double z = GENERATE(3.0, -1.0);
  CHECK(mesh.distance(0, {0.5, 0.5, z}) == about(2));
  CHECK(mesh.distance(0, {50, -70, z}) == about(2));
  CHECK(mesh.distance(0, {0.5, 0.5, 1}) < 1e-14);
}

TEST_CASE("the distance from a face is never less than the real one, however far or thin the face") {
  Random random(6);
  int less = 0, much_more = 0, regular = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double offset = std::pow(10, random.between(-2, 8)), thin = std::pow(10, random.between(-8, 0));
    const Vec3 a = offset * random.in_cube(1), ab = random.in_cube(1), beside = random.in_cube(1);
    const double along = random.between(0, 1);
    const Mesh mesh = triangle(a, a + ab, a + along * ab + thin * beside);
    const double u = random.between(0, 1), height = std::pow(10, random.between(-16, 0));
    const Vec3 p = a + u * ab + height * random.in_cube(1);
    const double real = true_distance(mesh, p), told = mesh.distance(0, p);
    if (!(told >= real)) ++less;
    if (thin < 0.1 || glm::length(glm::cross(ab, beside)) < 0.1) continue;
    ++regular;
    if (told > real * (1 + 1e-14) + 1e-12) ++much_more;
  }
  CHECK(less == 0);
  CHECK(regular > 1'000);
  CHECK(much_more == 0);
}
