// The ray tree: Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6) 1980, with the
// course's rules for what is attenuated where (docs/language.md section 6).
#pragma once

#include "shading/contribution.hpp"
#include "shading/partial_rgb.hpp"
#include "shading/ray_counts.hpp"
#include "shading/surface.hpp"
#include "shading/traced_scene.hpp"

namespace trace {

// Deepest ray tree; bounds the recursion.
inline constexpr int max_depth = 1000;

class WhittedTracer {
 public:
  // Refers to its arguments, which must outlive it. `counts` is for one thread.
  WhittedTracer(const TracedScene& world, RayCounts& counts)
      : world_(world), options_(world.options()), counts_(counts) {}

  // The colour seen along a primary ray, with at most `depth` bounces (0 to max_depth). Not clamped; it may
  // be infinite or undefined. With the scene's fog, which is between the eye and what it sees.
  //
  // A ray that leads nowhere hits nothing, and the cube map gives its colour as ever: one whose direction is
  // of length zero or not finite (a camera whose vectors cancel, or whose squares are beyond the range of
  // numbers), or whose origin is not finite. It is not handed to the hierarchy.
  PartialRgb trace(const Ray& ray, int depth) const;

 private:
  enum class Kind { visibility, reflection, refraction };
  struct Result {
    PartialRgb color;
    double t;  // of the hit; length_of_miss for none
  };

  // `weight` is that of the surface.
  Result trace(const Ray& ray, Kind kind, int depth, const Path& path) const;
  PartialRgb reflected(const Ray& ray, const Surface& surface, Kind kind, bool inside, int depth,
                       double weight) const;
  Result mirrored(const Ray& ray, const Surface& surface, Kind kind, int depth, const Path& path) const;
  PartialRgb refracted(const Ray& ray, const Surface& surface, bool inside, int depth, double weight) const;
  bool is_too_faint(double weight) const;

  const TracedScene& world_;
  const ShadingOptions& options_;
  RayCounts& counts_;
};

}  // namespace trace
