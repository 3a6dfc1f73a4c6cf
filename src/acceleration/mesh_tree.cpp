#include "acceleration/mesh_tree.hpp"

namespace trace {
namespace {

constexpr std::uint32_t max_leaf = 4;

}  // namespace

MeshTree::MeshTree(const Mesh& mesh) {
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
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t best_face = 0;
  traverse(bvh_, BvhRay(ray), limit, [&](std::uint32_t first, std::uint32_t count, double current) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      TriangleHit candidate;
      if (!intersect(triangles_[i], ray, candidate)) continue;
      if (!(candidate.t < best || (candidate.t == best && faces_[i] < best_face))) continue;
      if (cull && glm::dot(face_normal(triangles_[i]), ray.direction) > 0) continue;
      best = candidate.t;
      best_face = faces_[i];
      hit.t = candidate.t;
      hit.uv = Vec2(candidate.u, candidate.v);
    }
    return best < current ? best : current;
  });
  hit.part = best_face;
  return best < std::numeric_limits<double>::infinity();
}

bool MeshTree::occludes(const Ray& ray, double scale, double limit) const {
  bool found = false;
  traverse(bvh_, BvhRay(ray), limit * scale, [&](std::uint32_t first, std::uint32_t count, double current) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      TriangleHit candidate;
      if (intersect(triangles_[i], ray, candidate) && candidate.t / scale < limit) {
        found = true;
        return -1.0;
      }
    }
    return current;
  });
  return found;
}

}  // namespace trace
