// A mesh ready to be searched: its triangles in the order of its hierarchy's leaves.
#pragma once

#include "acceleration/bvh.hpp"
#include "geometry/mesh.hpp"

namespace trace {

class MeshTree {
 public:
  explicit MeshTree(const Mesh& mesh);

  // The nearest face, of faces at the same t the first in the file, no further than about `limit`; ray and t
  // in the space of the mesh. With `cull`, faces seen from behind are passed over. The hit's part is the
  // face, its uv the weights of the second and third corner; the normal is left alone.
  bool closest(const Ray& ray, double limit, bool cull, LocalHit& hit) const;

  // Whether any face is hit at t / scale < limit, seen from either side; `limit` is a distance in the world.
  bool occludes(const Ray& ray, double scale, double limit) const;

 private:
  Bvh bvh_;
  std::vector<Triangle> triangles_;   // in the order of the leaves
  std::vector<std::uint32_t> faces_;  // their numbers in the mesh
};

}  // namespace trace
