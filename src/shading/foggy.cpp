#include "shading/foggy.hpp"

namespace trace {

PartialRgb in_fog(const std::optional<Fog>& fog, const Ray& ray, const PartialRgb& seen, double t) {
  if (!fog) return seen;
  const double part = fog->part(ray, t);
  // A ray whose direction is no number has no place in the fog.
  if (!(part > 0)) return seen;
  if (part == 1) return fog->color;
  return PartialRgb(Rgb(1 - part)) * seen + PartialRgb(part * fog->color);
}

}  // namespace trace
