#include <bit>
#include <optional>

#include "tests/hard/batches.hpp"
#include "tests/hard/hierarchy_cases.hpp"

namespace trace::hard {
namespace {

void compare(Row& row, Digest& digest, const Scene& scene, const SceneTree& tree, const Ray& ray, bool cull) {
  const Hit truth = test::closest_of_all(scene, ray, cull), found = tree.closest(ray, cull);
  ++row.rays;
  if (bool(truth) != bool(found)) {
    ++(found ? row.wrong : row.misses);
  } else if (truth && (found.object != truth.object || found.local.part != truth.local.part ||
                       std::bit_cast<std::uint64_t>(found.t) != std::bit_cast<std::uint64_t>(truth.t))) {
    ++row.wrong;
  }
  // What is nearer than nothing is in the way, what is not is not.
  if (!cull && tree.occluded(ray, std::numeric_limits<double>::infinity()) != bool(truth)) ++row.wrong;
  digest.add_hit(found ? std::uint64_t{found.object} << 32 | found.local.part : ~0u, found ? found.t : 0);
}

std::vector<Row> run(std::uint64_t rays) {
  constexpr double units[] = {1, 1e-8, 1e8};
  const std::vector<Row> names{Row(ours, "sizes about 1"), Row(ours, "sizes about 1e-8"),
                               Row(ours, "sizes about 1e8")};
  return in_batches(rays, 33, names, [&](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
    std::vector<Digest> digests(rows.size());
    std::optional<Scene> scene;
    std::optional<SceneTree> tree;
    for (std::uint64_t i = 0; i < in_batch; ++i) {
      const auto kind = static_cast<std::size_t>(i / 64 % rows.size());
      if (i % 64 == 0) {
        scene = test::random_scene(random, 2 + static_cast<int>(random.below(20)), units[kind]);
        tree.emplace(*scene);
      }
      const Ray ray = test::random_ray(random, units[kind]);
      compare(rows[kind], digests[kind], *scene, *tree, ray, random.below(2) == 0);
    }
    for (std::size_t kind = 0; kind < rows.size(); ++kind) rows[kind].digest = digests[kind].value();
  });
}

}  // namespace

HardCase scene_hierarchy_case() {
  return {3,
          "the hierarchy of a scene finds the object and the t of testing every object, bit for bit",
          "Half of the objects lie on a grid, upright, so that surfaces and boxes coincide, and half of the "
          "rays run along "
          "axes and in planes of boxes, with zeros of either sign. The same rule orders hits in both: t, "
          "then the place "
          "in the file.",
          60'000,
          10'000'000,
          run};
}

}  // namespace trace::hard
