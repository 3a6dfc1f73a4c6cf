#include <fmt/format.h>
#include <tbb/global_control.h>

#include <memory>

#include "acceleration/scene_tree.hpp"
#include "tools/benchmark/kernels/embree_cost.hpp"
#include "tools/benchmark/kernels/mesh_scene.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

// Of the hierarchies of all meshes: the estimated work of a ray that meets the root, weighed by their
// triangles.
double surface_area_cost(const Bvh& bvh) {
  const auto surface = [](const float* low, const float* high) {
    const double x = double(high[0]) - low[0], y = double(high[1]) - low[1], z = double(high[2]) - low[2];
    return x * y + y * z + z * x;
  };
  constexpr std::size_t width = std::size(BvhNode{}.child);
  float root_low[3], root_high[3];
  for (int axis = 0; axis < 3; ++axis) {
    root_low[axis] = *std::min_element(bvh.nodes[0].low[axis], bvh.nodes[0].low[axis] + width);
    root_high[axis] = *std::max_element(bvh.nodes[0].high[axis], bvh.nodes[0].high[axis] + width);
  }
  const double whole = surface(root_low, root_high);
  double sum = whole;
  for (const BvhNode& node : bvh.nodes) {
    for (std::size_t child = 0; child < width; ++child) {
      const float low[] = {node.low[0][child], node.low[1][child], node.low[2][child]};
      const float high[] = {node.high[0][child], node.high[1][child], node.high[2][child]};
      if (low[0] <= high[0]) sum += surface(low, high) * std::max<int>(node.count[child], 1);
    }
  }
  return sum / whole;
}

// The mean over all meshes, weighed by their triangles, of what `cost` says of the boxes of one; none where
// it says nothing.
template <class Cost>
std::optional<double> weighed(const Scene& scene, Cost&& cost) {
  double sum = 0, triangles = 0;
  for (const SceneMesh& mesh : scene.meshes) {
    const Mesh& geometry = mesh.geometry;
    std::vector<Bounds> boxes(geometry.faces.size());
    for (std::size_t face = 0; face < boxes.size(); ++face) {
      for (const std::uint32_t corner : geometry.faces[face]) boxes[face].add(geometry.points[corner]);
    }
    if (boxes.empty()) continue;
    const std::optional<double> of_mesh = cost(boxes);
    if (!of_mesh) return std::nullopt;
    sum += *of_mesh * static_cast<double>(boxes.size());
    triangles += static_cast<double>(boxes.size());
  }
  return triangles > 0 ? std::optional(sum / triangles) : std::nullopt;
}

void print_cost(const char* whose, std::optional<double> cost) {
  if (cost) fmt::print("quality of={} surface_area_cost={:.4f}\n", whose, *cost);
}

}  // namespace

void measure_build(const BuildArguments& arguments) {
  const MeshScene meshes = read_mesh_scene(arguments.scene, 16);
  for (const int threads : arguments.threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    const Times times =
        repeated(arguments.repetitions, [&] { return std::make_unique<SceneTree>(meshes.scene); });
    const auto triangles = static_cast<double>(meshes.scene.triangle_count());
    fmt::print("build threads={} triangles={} {} Mtris/s={:.4f}\n", threads, triangles, times.text(),
               triangles / times.median() / 1000);
  }
  print_cost("ours", weighed(meshes.scene, [](const std::vector<Bounds>& boxes) {
               return std::optional(surface_area_cost(build_bvh(boxes, 4)));
             }));
  print_cost("embree", weighed(meshes.scene, embree_surface_area_cost));
}

}  // namespace trace::bench
