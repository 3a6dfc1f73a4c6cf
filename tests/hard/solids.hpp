// Convex primitives at places of every size, hit by a ray.
#pragma once

#include <optional>

#include "tests/hard/adapters.hpp"
#include "tests/hard/aimed_rays.hpp"

namespace trace::hard {

// One object: what may not be hit again by a ray that leaves it outward.
struct Solid {
  std::string_view name;
  Scene scene;
  double size;  // in the world, of its smallest side; what moves it is at most 1e6 times as large
  double offset;
};

enum class SolidKind { sphere, box, square, cylinder, cone, mesh };
inline constexpr int solid_kinds = 6;
std::string_view name_of(SolidKind kind);

// Turned, scaled by 10^(-8 ... 8), by up to 100 times as much along one axis as along another, maybe
// mirrored, and moved by up to 1e6 times its size, its coordinates at most 1e8.
Solid random_solid(Random& random, SolidKind kind);

// A hit of the solid by a ray from outside, at a random place or within some ulps of an edge of it.
struct Touch {
  Ray ray;
  Hit hit;
  Vec3 outward;  // in the world; of unit length
  Vec3 local;    // where, in the space of the object
};
std::optional<Touch> touch(Random& random, const Solid& solid, const SceneTree& tree);

}  // namespace trace::hard
