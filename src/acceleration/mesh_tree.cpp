#include "acceleration/mesh_tree.hpp"

#include <algorithm>

#include "acceleration/bvh_build.hpp"
#include "acceleration/mesh_kernels.hpp"
#include "acceleration/parallel_each.hpp"

namespace trace {
namespace {

constexpr LeafSizes face_leaves{4, bvh_width, 1};
constexpr std::size_t nodes_a_run = 128;

// With `memory` for as long as it takes.
Bvh hierarchy_of(const Mesh& mesh, const Bounds& bounds, LargeVector<float>& memory, ThreadBudget& threads) {
  BvhItems items(bounds, mesh.faces.size(), std::move(memory), threads, [&](std::size_t face) {
    const FaceCorners& f = mesh.faces[face];
    const DoubleLanes a = DoubleLanes::load(mesh.points[f[0]]), b = DoubleLanes::load(mesh.points[f[1]]),
                      c = DoubleLanes::load(mesh.points[f[2]]);
    return std::pair(min(a, min(b, c)), max(a, max(b, c)));
  });
  Bvh result = build_bvh(std::move(items), face_leaves, threads);
  memory = items.take_memory();
  return result;
}

}  // namespace

MeshTree::MeshTree(const Mesh& mesh, InstructionSet set, ThreadBudget& threads)
    : mesh_(&mesh), kernels_(&mesh_kernels(set)) {
  build(threads);
}

MeshTree::MeshTree(const Mesh& mesh, InstructionSet set) : mesh_(&mesh), kernels_(&mesh_kernels(set)) {
  ThreadBudget none(1);
  build(none);
}

void MeshTree::build(ThreadBudget& threads) {
  const Bounds bounds = mesh_->bounds();
  // Until the filter is made its memory serves for the hierarchy's references.
  static_assert(TriangleFilter::floats * sizeof(float) >= sizeof(BoxReference));
  filter_.values.resize(TriangleFilter::size_for(mesh_->faces.size()));
  bvh_ = hierarchy_of(*mesh_, bounds, filter_.values, threads);
  radius_ = sum_of_sizes(glm::max(bounds.max - centre(), centre() - bounds.min));
  sort_faces(threads);
  bvh_.order = {};
}

void MeshTree::sort_faces(ThreadBudget& threads) {
  faces_.resize(bvh_.order.size());
  parallel_runs(threads, bvh_.nodes.size(), nodes_a_run, [&](std::size_t first_node, std::size_t end) {
    for (std::size_t i = first_node; i < end; ++i) {
      const BvhNode& node = bvh_.nodes[i];
      for (int child = 0; child < bvh_width; ++child) {
        const std::uint32_t first = node.child[child], count = node.count[child];
        for (std::uint32_t place = 0; place < count; ++place) {
          const std::uint32_t face = bvh_.order[first + place];
          const FaceCorners& f = mesh_->faces[face];
          faces_[first + place] = {f, face};
          filter_.set(first, count, place, Triangle(mesh_->corners(f)), bvh_.centre);
        }
      }
    }
  });
  std::fill(filter_.values.end() - TriangleFilter::beyond, filter_.values.end(), 0.0f);
}

bool MeshTree::closest(const Ray& ray, double limit, bool cull, LocalHit& hit) const {
  NearestFace search(*this, ray, cull);
  kernels_->nearest(*this, ray, limit, search);
  return search.result(hit);
}

bool MeshTree::occludes(const Ray& ray, double scale, double limit) const {
  AnyFace search(*this, ray, scale, limit);
  kernels_->any(*this, ray, limit * scale, search);
  return search.result();
}

}  // namespace trace
