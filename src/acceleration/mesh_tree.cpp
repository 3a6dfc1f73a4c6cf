#include "acceleration/mesh_tree.hpp"

#include "acceleration/mesh_gaps.hpp"

namespace trace {
namespace {

constexpr std::uint32_t max_leaf = 4;

}  // namespace

MeshTree::MeshTree(const Mesh& mesh) : mesh_(&mesh) {
  const Bounds bounds = mesh.bounds();
  centre_ = 0.5 * bounds.min + 0.5 * bounds.max;
  radius_ = sum_of_sizes(bounds.max - centre_);

  std::vector<Bounds> boxes(mesh.faces.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::uint32_t corner : mesh.faces[face]) boxes[face].add(mesh.points[corner]);
  }
  bvh_ = build_bvh(boxes, max_leaf);
  faces_ = std::move(bvh_.order);
  triangles_.reserve(faces_.size());
  for (const std::uint32_t face : faces_) triangles_.push_back(mesh.triangle(face));
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
      if (meeting == Meeting::hit && candidate.t == best.t && faces_[i] > best_face) continue;
      if (cull && is_from_behind(i, ray)) continue;
      if (meeting != Meeting::hit) {
        gaps.add({candidate, faces_[i], meeting == Meeting::edge_gap, is_from_behind(i, ray)});
        continue;
      }
      best = candidate;
      best_face = faces_[i];
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
               gaps.add({candidate, faces_[i], meeting == Meeting::edge_gap, is_from_behind(i, ray)});
             }
             return current;
           });
  return found || gaps.nearest() != nullptr;
}

}  // namespace trace
