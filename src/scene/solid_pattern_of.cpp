#include "scene/solid_pattern_of.hpp"

#include <algorithm>

namespace trace {
namespace {

double number(const std::optional<parser::Scalar>& said, double otherwise) {
  return said ? said->value : otherwise;
}

Vec3 triple(const std::optional<parser::Vector3>& said, const Vec3& otherwise) {
  return said ? Vec3(said->value[0], said->value[1], said->value[2]) : otherwise;
}

}  // namespace

SolidPattern pattern_of(const parser::SolidTexture& said) {
  const bool marble = said.kind == parser::SolidTexture::Kind::marble;
  SolidPattern result;
  result.kind = marble ? SolidPattern::Kind::marble : SolidPattern::Kind::perlin_noise;
  result.color = triple(said.color, Rgb(1));
  result.lightness = number(said.lightness, 0.5);
  result.contrast = number(said.contrast, 0.8);
  result.frequency = number(said.frequency, 20);
  result.scale = triple(said.scale, Vec3(marble ? 1 : 4));
  const double most = SolidPattern::most_depth;
  result.depth = static_cast<int>(std::clamp(number(said.depth, marble ? 4 : 7), 0.0, most));
  return result;
}

}  // namespace trace
