// A mesh ready to be searched: its triangles in the order of its hierarchy's leaves.
#pragma once

#include <span>

#include "acceleration/bvh.hpp"
#include "acceleration/large_vector.hpp"
#include "acceleration/triangle_filter.hpp"
#include "geometry/mesh.hpp"
#include "geometry/rounding.hpp"
#include "instruction_set/instruction_set.hpp"
#include "parallel/parallel.hpp"

namespace trace {

struct MeshKernels;

// Its place in the list is its place in the order of the leaves.
struct LeafFace {
  FaceCorners corners;  // points of the mesh
  std::uint32_t face;   // its number in the mesh
};

class MeshTree {
 public:
  // Refers to `mesh`, which must outlive it.
  MeshTree(const Mesh& mesh, InstructionSet set, ThreadBudget& threads);
  explicit MeshTree(const Mesh& mesh, InstructionSet set = best_instruction_set());

  // The nearest face, of faces at the same t the first in the file, no further than about `limit`; ray and t
  // in the space of the mesh. With `cull`, faces seen from behind are passed over. The hit's part is the
  // face, its uv the weights of the second and third corner; the normal is left alone. Where the nearest is a
  // gap (mesh_gaps.hpp) it is the answer and marked.
  bool closest(const Ray& ray, double limit, bool cull, LocalHit& hit) const;

  // Whether any face is hit at t / scale < limit, seen from either side; `limit` is a distance in the world.
  bool occludes(const Ray& ray, double scale, double limit) const;

  // What searching it in other ways takes: leaves of the hierarchy are runs of faces().
  const Bvh& bvh() const { return bvh_; }
  std::span<const LeafFace> faces() const { return faces_; }
  const TriangleFilter& filter() const { return filter_; }
  Triangle triangle(std::uint32_t place) const { return Triangle(corners(place)); }
  Corners corners(std::uint32_t place) const { return mesh_->corners(faces_[place].corners); }

  // Of the lists that it holds.
  std::size_t bytes() const {
    return bytes_of(bvh_) + faces_.size() * sizeof(LeafFace) + filter_.values.size() * sizeof(float);
  }

  const Vec3& centre() const { return bvh_.centre; }
  double radius() const { return radius_; }
  // The sum of sizes of the way from any corner to the origin is at most this.
  double reach_to(const Vec3& origin) const { return sum_of_sizes(origin - centre()) + radius_; }

  // The triangle at `place`. `reach` is reach_to() the ray's origin. Never `unsure`.
  Meeting meet(std::uint32_t place, const Ray& ray, double reach, double limit, TriangleHit& hit) const {
    const Triangle at = triangle(place);
    // Numbers so large that sums of them could overflow are not bounded for all triangles at once.
    const double own_reach = reach < 0x1p300 ? reach : sum_of_sizes(ray.origin - at.a);
    const Meeting meeting = meets(at, ray, own_reach, limit, hit);
    return meeting == Meeting::unsure ? meets_after_all(corners(place), ray, hit) : meeting;
  }
  bool is_from_behind(std::uint32_t place, const Ray& ray) const {
    return glm::dot(face_normal(triangle(place)), ray.direction) > 0;
  }

 private:
  void build(ThreadBudget& threads);
  void sort_faces(ThreadBudget& threads);

  const Mesh* mesh_;
  double radius_;  // around the hierarchy's centre, as a sum of sizes
  Bvh bvh_;        // without its order, which is that of faces_
  LargeVector<LeafFace> faces_;
  TriangleFilter filter_;
  const MeshKernels* kernels_;
};

}  // namespace trace
