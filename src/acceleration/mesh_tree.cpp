#include "acceleration/mesh_tree.hpp"

#include "acceleration/bvh_build.hpp"
#include "acceleration/mesh_gaps.hpp"

namespace trace {
namespace {

constexpr LeafSizes leaf_sizes{2, 4, 1};

Bvh hierarchy_of(const Mesh& mesh, const Bounds& bounds, SpareThreads& threads) {
  BvhItems items(bounds, mesh.faces.size());
  for (const FaceCorners& f : mesh.faces) {
    const DoubleLanes a = DoubleLanes::load(mesh.points[f[0]]), b = DoubleLanes::load(mesh.points[f[1]]),
                      c = DoubleLanes::load(mesh.points[f[2]]);
    items.add(min(a, min(b, c)), max(a, max(b, c)));
  }
  return build_bvh(std::move(items), leaf_sizes, threads);
}

}  // namespace

MeshTree::MeshTree(const Mesh& mesh, SpareThreads& threads) : mesh_(&mesh) {
  build(threads);
}

MeshTree::MeshTree(const Mesh& mesh) : mesh_(&mesh) {
  SpareThreads none(0);
  build(none);
}

void MeshTree::build(SpareThreads& threads) {
  const Bounds bounds = mesh_->bounds();
  centre_ = 0.5 * bounds.min + 0.5 * bounds.max;
  radius_ = sum_of_sizes(bounds.max - centre_);
  bvh_ = hierarchy_of(*mesh_, bounds, threads);
  faces_.reserve(bvh_.order.size());
  for (const std::uint32_t face : bvh_.order) faces_.push_back({mesh_->faces[face], face});
  bvh_.order = {};
}

bool MeshTree::closest(const Ray& ray, double limit, bool cull, LocalHit& hit) const {
  TriangleHit best{std::numeric_limits<double>::infinity(), 0, 0};
  std::uint32_t best_face = 0;
  MeshGaps gaps;
  const double reach = reach_to(ray.origin);
  traverse(bvh_, BvhRay(bvh_, ray), limit, [&](std::uint32_t first, std::uint32_t count, double current) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      TriangleHit candidate;
      const Meeting meeting = meet(i, ray, reach, best.t, candidate);
      if (meeting == Meeting::none || candidate.t > best.t) continue;
      if (meeting == Meeting::hit && candidate.t == best.t && faces_[i].face > best_face) continue;
      if (cull && is_from_behind(i, ray)) continue;
      if (meeting != Meeting::hit) {
        gaps.add({candidate, faces_[i].face, meeting == Meeting::edge_gap, is_from_behind(i, ray)});
        continue;
      }
      best = candidate;
      best_face = faces_[i].face;
    }
    return best.t < current ? best.t : current;
  });
  // Where the course hits another face at the place of a gap, it is that face.
  const MeshGap* gap = gaps.nearest();
  hit.is_gap = gap && gap->hit.t < best.t && !same_place(best.t, gap->hit.t);
  if (hit.is_gap) {
    best = gap->hit;
    best_face = gap->face;
  }
  hit.t = best.t;
  hit.uv = Vec2(best.u, best.v);
  hit.part = best_face;
  return best.t < std::numeric_limits<double>::infinity();
}

bool MeshTree::occludes(const Ray& ray, double scale, double limit) const {
  bool found = false;
  const double reach = reach_to(ray.origin), furthest = limit * scale * (1 + gamma(2));
  MeshGaps gaps;
  traverse(bvh_, BvhRay(bvh_, ray), limit * scale,
           [&](std::uint32_t first, std::uint32_t count, double current) {
             for (std::uint32_t i = first; i < first + count; ++i) {
               TriangleHit candidate;
               const Meeting meeting = meet(i, ray, reach, furthest, candidate);
               if (meeting == Meeting::none || !(candidate.t / scale < limit)) continue;
               if (meeting == Meeting::hit) {
                 found = true;
                 return -1.0;
               }
               gaps.add({candidate, faces_[i].face, meeting == Meeting::edge_gap, is_from_behind(i, ray)});
             }
             return current;
           });
  return found || gaps.nearest() != nullptr;
}

}  // namespace trace
