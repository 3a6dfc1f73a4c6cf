// The same mesh in Embree, in single precision and its robust mode, to be compared with.
#pragma once

#include <memory>

#include "tests/hard/adapters.hpp"

namespace trace::hard {

#ifdef TRACE_EMBREE
inline constexpr bool embree_is_here = true;
#else
inline constexpr bool embree_is_here = false;
#endif

class EmbreeMesh {
 public:
  // Without Embree nothing is ever hit; ask embree_is_here.
  explicit EmbreeMesh(const Mesh& mesh);

  // Mesh and ray as Embree sees them: each number the nearest float.
  const Mesh& rounded() const { return rounded_; }
  static Ray rounded(const Ray& ray);

  bool closest(const Ray& ray, FaceHit& hit) const;

 private:
  struct Scene;
  Mesh rounded_;
  std::shared_ptr<const Scene> scene_;
};

}  // namespace trace::hard
