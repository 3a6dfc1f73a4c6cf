#include <fmt/format.h>

#include <memory>

#include "acceleration/scene_tree.hpp"
#include "tools/benchmark/kernels/embree_cost.hpp"
#include "tools/benchmark/kernels/mesh_scene.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

// Means over all meshes, weighed by their triangles. Embree's is missing where it cannot be had.
struct Costs {
  double ours = 0;
  std::optional<double> embree = 0;
};

Costs surface_area_costs(const Scene& scene, const SceneTree& tree) {
  Costs mean;
  const auto all = static_cast<double>(scene.triangle_count());
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i].geometry;
    if (mesh.faces.empty()) continue;
    const double weight = static_cast<double>(mesh.faces.size()) / all;
    std::vector<Bounds> boxes(mesh.faces.size());
    for (std::size_t face = 0; face < boxes.size(); ++face) {
      for (const std::uint32_t corner : mesh.faces[face]) boxes[face].add(mesh.points[corner]);
    }
    mean.ours += weight * surface_area_cost(tree.mesh({i}).bvh());
    const std::optional<double> embree = embree_surface_area_cost(boxes);
    mean.embree = mean.embree && embree ? std::optional(*mean.embree + weight * *embree) : std::nullopt;
  }
  return mean;
}

}  // namespace

void measure_build(const BuildArguments& arguments) {
  const MeshScene meshes = read_mesh_scene(arguments.scene, 16);
  for (const int threads : arguments.threads) {
    const Times times = repeated(arguments.repetitions, [&] {
      return std::make_unique<SceneTree>(meshes.scene, static_cast<unsigned>(threads));
    });
    const auto triangles = static_cast<double>(meshes.scene.triangle_count());
    fmt::print("build threads={} triangles={} {} Mtris/s={:.4f}\n", threads, triangles, times.text(),
               triangles / times.median() / 1000);
  }
  const Costs costs = surface_area_costs(meshes.scene, SceneTree(meshes.scene));
  fmt::print("quality of=ours surface_area_cost={:.4f}\n", costs.ours);
  if (costs.embree) fmt::print("quality of=embree surface_area_cost={:.4f}\n", *costs.embree);
}

}  // namespace trace::bench
