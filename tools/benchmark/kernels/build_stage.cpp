#include <fmt/format.h>

#include <memory>
#include <optional>
#include <vector>

#include "acceleration/scene_tree.hpp"
#include "tools/benchmark/kernels/embree_cost.hpp"
#include "tools/benchmark/kernels/mesh_scene.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

// Items that single rays are tested against at once: ours by the 32-bit filter, Embree's by Triangle4.
constexpr unsigned our_block = 8, embree_block = 4;

// A mean over all meshes, weighed by their triangles; none where it cannot be had of one.
class MeanCost {
 public:
  explicit MeanCost(std::size_t triangles) : all_(static_cast<double>(triangles)) {}

  void add(std::size_t triangles, std::optional<double> cost) {
    const double weight = static_cast<double>(triangles) / all_;
    mean_ = mean_ && cost ? std::optional(*mean_ + weight * *cost) : std::nullopt;
  }
  const std::optional<double>& value() const { return mean_; }

 private:
  double all_;
  std::optional<double> mean_ = 0;
};

void print_costs(const Scene& scene, const SceneTree& tree) {
  const std::size_t all = scene.triangle_count();
  MeanCost ours(all), ours_in_blocks(all), embree(all), embree_in_blocks(all);
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i].geometry;
    const std::size_t faces = mesh.faces.size();
    if (faces == 0) continue;
    std::vector<Bounds> boxes(faces);
    for (std::size_t face = 0; face < faces; ++face) {
      for (const std::uint32_t corner : mesh.faces[face]) boxes[face].add(mesh.points[corner]);
    }
    const Bvh& bvh = tree.mesh({i}).bvh();
    ours.add(faces, surface_area_cost(bvh));
    ours_in_blocks.add(faces, surface_area_cost(bvh, our_block));
    embree.add(faces, embree_surface_area_cost(boxes, 1));
    embree_in_blocks.add(faces, embree_surface_area_cost(boxes, embree_block));
  }
  const auto print = [](const char* of, const MeanCost& items, unsigned block, const MeanCost& blocks) {
    if (!items.value() || !blocks.value()) return;
    fmt::print("quality of={} surface_area_cost={:.4f} block={} cost_in_blocks={:.4f}\n", of, *items.value(),
               block, *blocks.value());
  };
  print("ours", ours, our_block, ours_in_blocks);
  print("embree", embree, embree_block, embree_in_blocks);
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
  print_costs(meshes.scene, SceneTree(meshes.scene));
}

}  // namespace trace::bench
