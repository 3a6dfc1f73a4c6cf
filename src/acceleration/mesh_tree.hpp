// A mesh ready to be searched: its triangles in the order of its hierarchy's leaves.
#pragma once

#include "acceleration/bvh.hpp"
#include "geometry/mesh.hpp"
#include "geometry/rounding.hpp"

namespace trace {

class MeshTree {
 public:
  // Refers to `mesh`, which must outlive it.
  explicit MeshTree(const Mesh& mesh);

  // The nearest face, of faces at the same t the first in the file, no further than about `limit`; ray and t
  // in the space of the mesh. With `cull`, faces seen from behind are passed over. The hit's part is the
  // face, its uv the weights of the second and third corner; the normal is left alone. Where the nearest is a
  // gap (mesh_gaps.hpp) it is the answer and marked.
  bool closest(const Ray& ray, double limit, bool cull, LocalHit& hit) const;

  // Whether any face is hit at t / scale < limit, seen from either side; `limit` is a distance in the world.
  bool occludes(const Ray& ray, double scale, double limit) const;

  // For packets (acceleration/packet): the triangle at a place in the order of the leaves and its face.
  const Bvh& bvh() const { return bvh_; }
  const Triangle& triangle(std::uint32_t place) const { return triangles_[place]; }
  std::uint32_t face(std::uint32_t place) const { return faces_[place]; }
  // The way from a point to any corner, as a sum of sizes, is at most that to the centre and the radius.
  const Vec3& centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  // The triangle at `place` in the order of the leaves. Never `unsure`.
  Meeting meet(std::uint32_t place, const Ray& ray, double reach, double limit, TriangleHit& hit) const {
    const Triangle& triangle = triangles_[place];
    // Numbers so large that sums of them could overflow are not bounded for all triangles at once.
    const double own_reach = reach < 0x1p300 ? reach : sum_of_sizes(ray.origin - triangle.a);
    const Meeting meeting = meets(triangle, ray, own_reach, limit, hit);
    return meeting == Meeting::unsure ? meets_after_all(mesh_->corners(faces_[place]), ray, hit) : meeting;
  }

  // The sum of sizes of the way from any corner to the origin is at most this.
  double reach_to(const Vec3& origin) const { return sum_of_sizes(origin - centre_) + radius_; }
  bool is_from_behind(std::uint32_t place, const Ray& ray) const {
    return glm::dot(face_normal(triangles_[place]), ray.direction) > 0;
  }

  const Mesh* mesh_;
  Vec3 centre_;
  double radius_;  // as a sum of sizes
  Bvh bvh_;
  std::vector<Triangle> triangles_;   // in the order of the leaves
  std::vector<std::uint32_t> faces_;  // their numbers in the mesh
};

}  // namespace trace
