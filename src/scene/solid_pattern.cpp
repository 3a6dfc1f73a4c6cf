#include "scene/solid_pattern.hpp"

#include <algorithm>

#include "scene/perlin_noise.hpp"

namespace trace {
namespace {

Rgb marble_at(const SolidPattern& marble, const Vec3& p) {
  double octaves = 0, weight = 1;
  for (int i = 0; i < marble.depth; ++i, weight /= 2) octaves += weight;
  const double turbulence = octaves * perlin_noise(p * marble.scale);
  const double wave = std::sin(marble.frequency * (p.x + marble.contrast * turbulence));
  return std::max(0.0, marble.lightness + (1 - marble.lightness) * wave) * marble.color;
}

Rgb noise_at(const SolidPattern& pattern, const Vec3& p) {
  double turbulence = 0, weight = 1, frequency = 1;
  for (int i = 0; i < pattern.depth; ++i, weight /= 2, frequency *= 2) {
    turbulence += weight * perlin_noise(frequency * p);
  }
  return Rgb(0.5 * (1 + std::sin(pattern.scale.z * p.z + 10 * std::abs(turbulence))));
}

}  // namespace

Rgb SolidPattern::at(const Vec3& p) const {
  if (!is_finite(p)) return Rgb(0);
  return kind == Kind::marble ? marble_at(*this, p) : noise_at(*this, p);
}

}  // namespace trace
