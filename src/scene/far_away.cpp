#include "scene/far_away.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/bounded_matrix.hpp"
#include "geometry/rounding.hpp"

namespace trace {

std::string FarAway::message(const std::string& what) const {
  return fmt::format(
      "this {} is {:.2g} across and {:.2g} from the origin, where double precision has steps of {:.2g}", what,
      size, distance, spacing);
}

std::optional<FarAway> find_far_away(const Bounds& local, const Mat4& to_world) {
  if (local.unbounded()) return std::nullopt;
  const Bounds world = transformed(local, to_world);
  FarAway found{};
  found.distance = std::max(largest(world.min), largest(world.max));
  // The difference of the world's bounds is what may have been lost: the extents from the matrix instead.
  found.size = largest(Vec3(absolute(to_world) * Vec4(local.max - local.min, 0)));
  found.spacing = std::nextafter(found.distance, HUGE_VAL) - found.distance;
  if (!(found.size > 0 && found.spacing > 1e-6 * found.size)) return std::nullopt;
  return found;
}

std::string name_of(const decltype(parser::Primitive::shape)& shape) {
  static constexpr const char* names[] = {"sphere",  "box",        "square",      "cylinder",
                                          "cone",    "trimesh",    "plane",       "torus",
                                          "quadric", "torus_knot", "height_field"};
  static_assert(std::variant_size_v<decltype(parser::Primitive::shape)> == std::size(names));
  return names[shape.index()];
}

}  // namespace trace
