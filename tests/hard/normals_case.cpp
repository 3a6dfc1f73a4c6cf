// Row 8: normals of objects that are tiny, huge, mirrored or flat.
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/frame.hpp"
#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/quad_linear.hpp"
#include "tests/hard/space_cases.hpp"

namespace trace::hard {
namespace {

struct Workload {
  const char* name;
  Vec3 scale;
};

constexpr Workload workloads[] = {{"scale (1, 2, 4)", {1, 2, 4}},
                                  {"scale (1, 2, 4) 1e-16", {1e-16, 2e-16, 4e-16}},
                                  {"scale (1, 2, 4) 1e-110", {1e-110, 2e-110, 4e-110}},
                                  {"scale (1, 2, 4) 1e110", {1e110, 2e110, 4e110}},
                                  {"mirrored", {-1, 2, 4}},
                                  {"mirrored thrice, 1e-110", {-1e-110, -2e-110, -4e-110}},
                                  {"flat, z = 0", {1, 2, 0}}};

// Scales differ by up to 4, which takes a normal's 2^-53 to 16 times that; forming the cofactors adds a few.
constexpr double allowed = 64 * 0x1p-53;

// How far a normal is from the true one, which stands across the transformed tangents, on its own side. Of a
// flattened object both sides are its own.
double off(const Mat4& place, const Vec3& local, const Vec3& normal) {
  const QuadLinear linear(place);
  // Cofactors are squares of scales, and their squares beyond what the double within root() holds.
  const QuadVec n = linear.cofactors() * QuadVec(local);
  const Quad largest = std::max({magnitude(n.x), magnitude(n.y), magnitude(n.z)});
  const QuadVec scaled = (1 / largest) * n;
  QuadVec truth = (1 / length(scaled)) * scaled;
  const Quad det = linear.determinant();
  const QuadVec given(normal);
  if (det < 0 || (det == 0 && dot(given, truth) < 0)) truth = Quad(-1) * truth;
  return static_cast<double>(length(given - truth));
}

void note(double difference, Row& row) {
  ++row.rays;
  if (!(difference <= allowed)) ++row.wrong;
}

std::vector<Row> run(std::uint64_t normals) {
  std::vector<Row> all;
  std::uint32_t seed = 800;
  for (const Workload& workload : workloads) {
    const auto rows = in_batches(
        normals / std::size(workloads), seed++,
        {Row(ours, workload.name), Row("glm::inverseTranspose", workload.name)},
        [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
          Digest digest;
          for (std::uint64_t i = 0; i < count; ++i) {
            const Mat4 place = glm::scale(random_turn(random), workload.scale);
            const Vec3 local = glm::normalize(random.in_cube(1) + Vec3(1.5, 0, 0.1));
            const Vec3 normal = Frame(place).world_normal(local);
            for (int axis = 0; axis < 3; ++axis) digest.add(normal[axis]);
            note(off(place, local, normal), out[0]);
            note(off(place, local, glm::normalize(glm::inverseTranspose(Mat3(place)) * local)), out[1]);
          }
          out[0].digest = digest.value();
        });
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

HardCase normals_case() {
  return {8,
          "normals are right for tiny, huge, mirrored and flat objects",
          "The determinant of a scale of 1e-110 is below what a double holds, and a flat object has none. "
          "Cofactors need no division by it, only its sign.",
          7'000,
          700'000,
          run};
}

}  // namespace trace::hard
