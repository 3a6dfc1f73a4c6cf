// How the hard cases reach what they try: each way in one place.
#pragma once

#include <vector>

#include "shading/surface.hpp"
#include "tests/hard/exact.hpp"

namespace trace::hard {

struct FaceHit {
  std::uint32_t face;
  double t;
};

// The triangle predicate on one face: exact, but for faces that the fast form certainly misses.
inline bool meets(const Mesh& mesh, std::uint32_t face, const Ray& ray, double& t) {
  TriangleHit hit;
  if (trace::meets(mesh.triangle(face), ray, hit) == Meeting::none) return false;
  if (!crosses_exactly(mesh.corners(face), ray, hit)) return false;
  t = hit.t;
  return true;
}

// All faces that the predicate accepts, in the order of the file, without a hierarchy.
inline void all_hits(const Mesh& mesh, const Ray& ray, std::vector<FaceHit>& hits) {
  hits.clear();
  double t = 0;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (meets(mesh, face, ray, t)) hits.push_back({face, t});
  }
}

// A secondary ray: from the surface that `ray` met at `hit`.
inline Ray leaving(const Scene& scene, const Ray& ray, const Hit& hit, const Vec3& direction) {
  return Surface(scene, ray, hit, false).leaving(direction);
}

}  // namespace trace::hard
