// Objects that lie so far from the origin that doubles cannot resolve them.
#pragma once

#include <optional>
#include <string>

#include "geometry/bounds.hpp"
#include "parser/description.hpp"

namespace trace {

struct FarAway {
  double distance;  // the largest coordinate of the object
  double size;      // its largest extent along an axis
  double spacing;   // of the doubles next to `distance`: more than 1e-6 of the size

  // "this sphere is 0.001 across and 1e+09 from the origin, where double precision has steps of 1.2e-07"
  std::string message(const std::string& what) const;
};

// For an object with bounds `local` in its own space. Nothing for one without extent or without an end.
std::optional<FarAway> find_far_away(const Bounds& local, const Mat4& to_world);

// "sphere", "trimesh", ...
std::string name_of(const decltype(parser::Primitive::shape)& shape);

}  // namespace trace
