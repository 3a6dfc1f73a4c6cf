// A ray and its hits in any kind of number.
#pragma once

#include <cstdint>

#include "precision/numbers.hpp"

namespace trace::precision {

template <class T>
struct Ray {
  Vec3<T> origin;
  Vec3<T> direction;  // unit length
  T least_t = 0;      // hits up to here are those of the surface that the ray leaves (surface.hpp)

  Vec3<T> at(T t) const { return origin + t * direction; }
};

// In the space of the object; what geometry/ray.hpp says of LocalHit, but `normal` has unit length or is
// that of a mesh's face, which is not computed before the nearest is known.
template <class T>
struct LocalHit {
  T t = 0;
  Vec3<T> normal{0, 0, 1};
  Vec2<T> uv{0, 0};
  std::uint32_t part = 0;
};

// In the world.
template <class T>
struct Hit {
  T t = std::numeric_limits<T>::infinity();
  std::uint32_t object = 0;
  LocalHit<T> local;

  explicit operator bool() const { return t < std::numeric_limits<T>::infinity(); }
};

}  // namespace trace::precision
