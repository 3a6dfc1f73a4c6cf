// Row 9: a hit has the same place in both spaces.
#include <glm/gtc/matrix_transform.hpp>

#include "acceleration/scene_tree.hpp"
#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/nearby_rays.hpp"
#include "tests/hard/quad_linear.hpp"
#include "tests/hard/space_cases.hpp"
#include "tests/support/scene_make.hpp"

namespace trace::hard {
namespace {

// Scales of 1e-2 to 1e2, which differ by axis.
Mat4 random_place(Random& random) {
  Vec3 scale;
  for (int axis = 0; axis < 3; ++axis) scale[axis] = std::pow(10.0, random.between(-2, 2));
  const Vec3 offset = random.in_cube(10);
  return glm::scale(glm::translate(Mat4(1), offset) * random_turn(random), scale);
}

// The sphere in the space that `place` makes, met by the ray as it is there: t is not touched by the way
// into the space, for the direction is not made a unit vector.
TrueHit true_placed_sphere(const QuadRay& world, const Mat4& place) {
  const QuadLinear linear(place);
  const QuadVec o = linear.solve(world.origin - QuadVec(Vec3(place[3]))), d = linear.solve(world.direction);
  const Quad dd = dot(d, d), to_middle = -dot(o, d) / dd;
  const QuadVec across = o + to_middle * d;
  const Quad left = 1 - dot(across, across);
  if (left < 0) return std::nullopt;
  const Quad half_chord = root(left / dd);
  if (to_middle + half_chord <= 0) return std::nullopt;
  return to_middle > half_chord ? to_middle - half_chord : to_middle + half_chord;
}

// The language takes a ray into the space by o and o + d; with |o| up to 64 the sum is rounded by 2^-53 * 32
// in each coordinate, which turns the ray by up to twice that, and the two products with the inverse round
// as much again each. The rays around turn it by at least half the band.
constexpr double band = 256 * 0x1p-53, allowed = 1e-12;

std::vector<Row> run(std::uint64_t rays) {
  return in_batches(
      rays, 910, {Row(ours, "spheres scaled by 1e-2 ... 1e2")},
      [](Random& random, std::uint64_t count, std::vector<Row>& out) {
        Digest digest;
        for (std::uint64_t i = 0; i < count; ++i) {
          const Mat4 place = random_place(random);
          Scene scene;
          test::add(scene, Sphere{}, place, Material{});
          const SceneTree tree(scene);
          const Vec3 target(place * Vec4(random.in_cube(0.5), 1));
          const Vec3 origin = target + random.in_cube(50);
          const Ray ray{origin, glm::normalize(target - origin)};
          const Hit hit = tree.closest(ray, false);
          digest.add_hit(bool(hit), hit ? hit.t : 0);
          note_answer([&](const QuadRay& r) { return true_placed_sphere(r, place); }, ray, band, bool(hit),
                      hit.t, allowed, out[0]);
        }
        out[0].digest = digest.value();
      },
      64);
}

}  // namespace

HardCase shared_t_case() {
  return {9,
          "the t of a hit in the world is that of the exact ray in the exact space of the object",
          "A ray is taken into the space of an object and its t back. Neither the length of the direction "
          "there nor the difference of scales by axis may cost digits of t.",
          2'000,
          200'000,
          run};
}

void add_space_cases(std::vector<HardCase>& cases) {
  cases.push_back(normals_case());
  cases.push_back(undone_case());
  cases.push_back(shared_t_case());
}

}  // namespace trace::hard
