// Whether the faces that a predicate accepts are the crossings of a ray with a closed mesh.
#pragma once

#include <span>

#include "tests/hard/adapters.hpp"

namespace trace::hard {

// How often the ray passes out of a mesh. Through the inside of a face it must be accepted by that face
// alone; exactly through an edge or a corner, by exactly the faces that share it, which count as one
// crossing, or as none where the ray only touches. What is exact is decided by exact arithmetic.
class Crossings {
 public:
  explicit Crossings(const Mesh& mesh);

  struct Count {
    int crossings = 0;
    bool sound = true;  // each accepted face is truly met and none of those that share the place is left out
    bool certain = true;  // false: through a corner that the ray may pass or only touch
  };
  Count count(const Ray& ray, std::span<const FaceHit> accepted) const;

 private:
  const Mesh& mesh_;
  std::vector<std::vector<std::uint32_t>> faces_at_;  // of each point
};

}  // namespace trace::hard
