// Packets through whole scenes against SceneTree.
#include "tests/packets/same_bits.hpp"
#include "tests/support/scene_endless.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Every ray by itself.
std::vector<Ray> scattered(Random& random, double unit, int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) rays.push_back(random_ray(random, unit));
  return rays;
}

// Bundles of sixteen from one origin, as from an eye.
std::vector<Ray> bundled(Random& random, double unit, int count) {
  std::vector<Ray> rays;
  while (rays.size() < static_cast<std::size_t>(count)) {
    const Ray middle = random_ray(random, unit);
    for (int i = 0; i < 16; ++i) {
      rays.push_back({middle.origin, glm::normalize(middle.direction + random.in_cube(0.02))});
    }
  }
  return rays;
}

// From the surfaces of the scene, as reflected and shadow rays leave them.
std::vector<Ray> leaving(const SceneTree& tree, const std::vector<Ray>& rays, Random& random, double unit) {
  std::vector<Ray> result;
  for (const Ray& ray : rays) {
    const Hit hit = tree.closest(ray, false);
    if (!hit) continue;
    const double error = unit * std::pow(10.0, random.between(-15, -13));
    const Vec3 direction = glm::normalize(random.in_cube(1) + Vec3(0, 0, 0.01));
    result.push_back({ray.at(hit.t), direction, error, 4 * error});
  }
  return result;
}

struct Disagreements {
  int hits = 0, different = 0, shadows = 0;
  std::string first;  // the first ray that differs
};

void compare(const Scene& scene, const SceneTree& tree, const std::vector<Ray>& rays, Disagreements& result) {
  for (const PacketKernels& kernels : packet_kernels()) {
    for_each_packet(rays, kernels.lanes, [&](std::span<const Ray> packet, std::size_t first) {
      const unsigned some = first % 3 == 0 ? 0xb6d7u : first % 7 == 0 ? 0x0100u : 0xffffu;
      const unsigned active = all_of(packet.size()) & some;
      std::vector<double> limits;
      for (const bool cull : {false, true}) {
        const auto found = kernels.closest(scene, tree, packet, active, cull);
        for (std::size_t i = 0; i < packet.size(); ++i) {
          const Hit expected = tree.closest(packet[i], cull);
          if (!cull) {
            const double factors[] = {1, 1 + 1e-9, 0.5};
            limits.push_back(expected ? expected.t * factors[(first + i) % 3] : 1e300);
          }
          if ((active >> i & 1) == 0) continue;
          if (expected) ++result.hits;
          const bool same =
              same_bits(expected.t, found[i].t) && (!expected || (expected.object == found[i].object &&
                                                                  same_bits(expected.local, found[i].local)));
          if (same) continue;
          ++result.different;
          if (result.first.empty()) result.first = std::string(name_of(kernels.set)) + ' ' + shown(packet[i]);
        }
      }
      unsigned expected = 0;
      for (std::size_t i = 0; i < packet.size(); ++i) {
        if (tree.occluded(packet[i], limits[i])) expected |= 1u << i;
      }
      if (kernels.occluded(scene, tree, packet, active, limits) != (expected & active)) ++result.shadows;
    });
  }
}

}  // namespace

TEST_CASE("packets find in a scene what single rays find, bit for bit") {
  Random random(GENERATE(range(1u, 7u)));
  const int size = GENERATE(1, 3, 40);
  const double unit = GENERATE(1.0, 1e-6, 50.0, 1e6);
  const Scene scene = random_scene(random, size, unit);
  const SceneTree tree(scene);
  Disagreements result;
  const auto apart = scattered(random, unit, 150), together = bundled(random, unit, 160);
  compare(scene, tree, apart, result);
  compare(scene, tree, together, result);
  compare(scene, tree, leaving(tree, together, random, unit), result);
  INFO(result.first);
  CHECK(result.different == 0);
  CHECK(result.shadows == 0);
  if (size == 40 && !packet_kernels().empty()) CHECK(result.hits > 100);
}

TEST_CASE("packets find shapes of the dialects and those without an end as single rays do, bit for bit") {
  Random random(GENERATE(range(21u, 25u)));
  const int size = GENERATE(1, 3, 20);
  const double unit = GENERATE(1.0, 1e-6, 50.0);
  const Scene scene = endless_scene(random, size, unit);
  const SceneTree tree(scene);
  Disagreements result;
  const auto apart = scattered(random, unit, 150), together = bundled(random, unit, 160);
  compare(scene, tree, apart, result);
  compare(scene, tree, together, result);
  compare(scene, tree, leaving(tree, together, random, unit), result);
  INFO(result.first);
  CHECK(result.different == 0);
  CHECK(result.shadows == 0);
  CHECK((result.hits > 100 || packet_kernels().empty()));
}

TEST_CASE("packets find in a mesh what single rays find, also on its edges and corners") {
  Random random(17);
  // A sheet of unit squares with bumps, each of two triangles.
  constexpr std::uint32_t size = 12;
  Mesh sheet;
  for (std::uint32_t i = 0; i <= size; ++i) {
    for (std::uint32_t j = 0; j <= size; ++j) sheet.points.push_back({i, j, random.below(3) * 0.5});
  }
  for (std::uint32_t i = 0; i < size; ++i) {
    for (std::uint32_t j = 0; j < size; ++j) {
      const std::uint32_t corners[] = {i * (size + 1) + j, (i + 1) * (size + 1) + j,
                                       (i + 1) * (size + 1) + j + 1, i * (size + 1) + j + 1};
      add_polygon(sheet, corners, 4);
    }
  }
  Scene scene;
  add(scene, sheet, Mat4(1), Material{});
  add(scene, sheet, glm::rotate(Mat4(1), 0.3, Vec3(1, 2, 3)), Material{});
  const SceneTree tree(scene);
  std::vector<Ray> rays;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = random.below(2) == 0 ? Vec3(6, 6, 0) + random.on_grid(20, 0.5) : random.in_cube(12);
    const Vec3& corner = sheet.points[random.below(static_cast<std::uint32_t>(sheet.points.size()))];
    const Vec3& other = sheet.points[random.below(static_cast<std::uint32_t>(sheet.points.size()))];
    const Vec3 target = random.below(2) == 0 ? corner : 0.5 * (corner + other);
    if (origin != target) rays.push_back({origin, glm::normalize(target - origin)});
  }
  Disagreements result;
  compare(scene, tree, rays, result);
  INFO(result.first);
  CHECK(result.different == 0);
  CHECK(result.shadows == 0);
  CHECK((result.hits > 1000 || packet_kernels().empty()));
}
