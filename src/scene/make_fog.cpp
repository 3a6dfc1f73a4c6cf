#include "scene/make_fog.hpp"

#include "geometry/unit_vector.hpp"

namespace trace {

std::optional<Fog> make_fog(const parser::Fog& said, parser::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  Fog fog;
  if (said.color) {
    fog.color = Rgb(said.color->value[0], said.color->value[1], said.color->value[2]);
  } else {
    diagnostics.error(said.keyword, "fog has no 'color'");
  }
  if (said.axis) {
    const Vec3 axis(said.axis->value[0], said.axis->value[1], said.axis->value[2]);
    fog.axis = unit_vector(axis).direction;
    if (is_zero(axis) || !is_finite(*fog.axis))
      diagnostics.error(said.axis->span, "'axis' must be longer than 0");
  }
  if (said.start) fog.start = said.start->value;
  if (said.density && said.end) {
    diagnostics.error(said.density->span, "fog has both 'end' and 'density': it is linear or exponential");
  } else if (said.density) {
    fog.density = said.density->value;
    if (!(fog.density >= 0)) diagnostics.error(said.density->span, "'density' must not be negative");
  } else if (said.end) {
    fog.end = said.end->value;
    if (said.axis ? *fog.end == fog.start : !(*fog.end > fog.start)) {
      diagnostics.error(said.end->span,
                        said.axis ? "'end' must not be 'start'" : "'end' must be greater than 'start'");
    }
  } else {
    diagnostics.error(said.keyword, "fog has no 'end' and no 'density'");
  }
  if (diagnostics.error_count() > errors) return std::nullopt;
  return fog;
}

}  // namespace trace
