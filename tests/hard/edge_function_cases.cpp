#include <array>

#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/textbook_triangle.hpp"
#include "tests/hard/watertight_cases.hpp"

namespace trace::hard {
namespace {

using Form = bool (*)(const Mesh&, const Ray&);

bool by_trace(const Mesh& mesh, const Ray& ray) {
  double t = 0;
  return meets(mesh, 0, ray, t);
}

bool by_textbook(const Mesh& mesh, const Ray& ray) {
  double t = 0;
  return textbook_meets(mesh.corners(0), ray, t);
}

// The plain edge functions of Woop, Benthin and Wald (2013), seen along the ray, in float and without their
// exact fallback: U = cx by - cy bx and so on. For rays along -z alone.
bool by_float(const Mesh& mesh, const Ray& ray) {
  std::array<glm::vec2, 3> p;
  for (int i = 0; i < 3; ++i) p[i] = glm::vec2(mesh.points[mesh.faces[0][i]]) - glm::vec2(ray.origin);
  const float u = p[2].x * p[1].y - p[2].y * p[1].x, v = p[0].x * p[2].y - p[0].y * p[2].x,
              w = p[1].x * p[0].y - p[1].y * p[0].x;
  return !((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) && u + v + w != 0;
}

// Asks `form` for all six orders of the corners.
void compare(Row& row, Digest& digest, Form form, const Corners& c, const Ray& ray) {
  const bool truth = line_hits(ray, c);
  Mesh mesh;
  mesh.points = {c.a, c.b, c.c};
  for (const FaceCorners& order :
       {FaceCorners{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
    mesh.faces = {order};
    const bool found = form(mesh, ray);
    ++row.rays;
    digest.add(std::uint64_t{found});
    if (truth && !found) ++row.misses;
    if (found && !truth) ++row.wrong;
  }
}

// An edge that passes the point where the ray is at t, but for rounding and some ulps; the third corner
// anywhere.
Corners near_edge(Random& random, const Vec3& point, const Vec3& across) {
  Corners c{point + across, point - random.between(0.1, 3) * across, point + random.in_cube(2)};
  if (random.below(2) == 0) {
    double& x = c.b[static_cast<int>(random.below(3))];
    x = steps_from(x, static_cast<int>(random.below(9)) - 4);
  }
  return c;
}

// Points of 24 bits around the axis of the ray (0, 0, 1) -> (0, 0, -1), two of them nearly in line with it,
// as 33962.035 x -30438.8 - 41563.4 x -24871.969 is nearly zero: -75, and in floats -128.
Corners of_floats(Random& random) {
  // Rounded as integers: g++ 12 leaves out the rounding of a double to float and back.
  const auto one = [&] { return 0x1p-9 * ((1u << 22) + random.below(3u << 22)); };  // 8192 ... 32768
  const auto rounded = [](double x) { return std::nearbyint(x * 0x1p8) * 0x1p-8; };
  const double ax = one(), ay = one(), s = -random.between(0.3, 1.9), cx = one(), cy = -one();
  return {{ax, ay, 0}, {rounded(s * ax), rounded(s * ay), 0}, {cx, cy, 0}};
}

std::vector<Row> run(std::uint64_t rays) {
  const std::vector<Row> names{Row(ours, "double, any direction"), Row("textbook", "double, any direction"),
                               Row(ours, "corners of 24 bits"), Row("textbook", "corners of 24 bits"),
                               Row("float", "corners of 24 bits")};
  return in_batches(rays / 12, 2, names, [](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
    std::vector<Digest> digests(rows.size());
    const Ray down{{0, 0, 1}, {0, 0, -1}};
    for (std::uint64_t i = 0; i < in_batch; ++i) {
      const Ray ray{random.in_cube(4), unit_vector(random)};
      const Vec3 point = ray.at(random.between(0.5, 4)), across = random.in_cube(1);
      const Corners c = near_edge(random, point, across);
      compare(rows[0], digests[0], by_trace, c, ray);
      compare(rows[1], digests[1], by_textbook, c, ray);

      const Corners f =
          i == 0 ? Corners{{33962.035f, 41563.4f, 0}, {-24871.969f, -30438.8f, 0}, {3e4f, -3e4f, 0}}
                 : of_floats(random);
      compare(rows[2], digests[2], by_trace, f, down);
      compare(rows[3], digests[3], by_textbook, f, down);
      compare(rows[4], digests[4], by_float, f, down);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].digest = digests[i].value();
  });
}

}  // namespace

HardCase edge_function_case() {
  return {2,
          "a triangle is hit exactly where exact arithmetic says so, whatever the order of its corners",
          "The edge that the ray passes is off it by ulps, so that the products of its edge function cancel "
          "to nothing or "
          "to noise. The sign is taken from the rounded value only beyond its forward error bound, and "
          "otherwise from "
          "sums that do not round; t stays that of the course's form.",
          60'000,
          12'000'000,
          run};
}

}  // namespace trace::hard
