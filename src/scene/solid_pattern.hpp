// Colours that are computed from a point of space: marble and noise.
#pragma once

#include "geometry/vector.hpp"

namespace trace {

struct SolidPattern {
  enum class Kind { marble, perlin_noise };
  static constexpr int most_depth = 32;  // beyond, an octave is less than 2^-32 of the first

  Kind kind = Kind::marble;
  Rgb color{1};                            // of marble
  double lightness = 0.5, contrast = 1.0;  // of marble
  double frequency = 1;                    // of marble
  Vec3 scale{1};
  int depth = 1;  // octaves, 0 to most_depth

  // At a point p of the object's own space. With noise() of perlin_noise.hpp:
  //
  // Marble, as in some HKUST projects, whose octaves all have the same frequency:
  //   t = (1 + 1/2 + ... + 1/2^(depth-1)) noise(scale p)
  //   color max(0, lightness + (1 - lightness) sin(frequency (p.x + contrast t)))
  //
  // Noise (P. Shirley, "Ray Tracing: The Next Week", 2016, section 4.7), grey:
  //   t = |noise(p) + noise(2 p) / 2 + ... + noise(2^(depth-1) p) / 2^(depth-1)|
  //   (1 + sin(scale.z p.z + 10 t)) / 2
  Rgb at(const Vec3& p) const;
};

}  // namespace trace
