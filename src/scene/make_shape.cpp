#include "scene/make_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trace {
namespace {

Vec3 vector_or(const std::optional<parser::Vector3>& said, const Vec3& otherwise) {
  return said ? Vec3(said->value[0], said->value[1], said->value[2]) : otherwise;
}

double number_or(const std::optional<parser::Scalar>& said, double otherwise) {
  return said ? said->value : otherwise;
}

std::optional<Quadric> make_paraboloid(const parser::Quadric& said, parser::Diagnostics& diagnostics) {
  const double a = std::abs(number_or(said.a, 1)), b = std::abs(number_or(said.b, 1));
  const double low = number_or(said.lower_bound, 0), high = number_or(said.upper_bound, 1);
  for (const auto& [name, width] : {std::pair{'A', said.a}, std::pair{'B', said.b}}) {
    if (!width || std::isfinite(1 / (width->value * width->value))) continue;
    diagnostics.error(width->span, fmt::format("'{}' of a paraboloid must not be 0", name));
    return std::nullopt;
  }
  if (!(high > low)) {
    diagnostics.error((said.upper_bound ? said.upper_bound : said.lower_bound)->span,
                      "'upper_bound' of a paraboloid must be greater than 'lower_bound'");
    return std::nullopt;
  }
  if (!(high > 0)) {
    diagnostics.error(said.upper_bound->span, "'upper_bound' of a paraboloid must be greater than 0");
    return std::nullopt;
  }
  Bounds limits = Bounds::everything();
  limits.min.y = low;
  limits.max.y = high;
  // Wider by more than the rounding of the rim, which the language's test of boxes must not cut off.
  const double wide = std::sqrt(high) * (1 + 0x1p-40);
  const Bounds extent{{-a * wide, std::max(low, 0.0), -b * wide}, {a * wide, high, b * wide}};
  return Quadric({1 / (a * a), 0, 1 / (b * b), 0, 0, 0, 0, -1, 0, 0}, limits, extent);
}

std::optional<Quadric> make_general(const parser::Quadric& said, parser::Diagnostics& diagnostics) {
  if (!said.coefficients_span) return Quadric({1, -1, 1, 0, 0, 0, 0, 0, 0, -1});
  Quadric::Coefficients coefficients;
  if (said.coefficients.size() != coefficients.size()) {
    diagnostics.error(*said.coefficients_span, fmt::format("a quadric has ten coefficients, this one has {}",
                                                           said.coefficients.size()));
    return std::nullopt;
  }
  std::copy(said.coefficients.begin(), said.coefficients.end(), coefficients.begin());
  if (std::all_of(coefficients.begin(), coefficients.end() - 1, [](double x) { return x == 0; })) {
    diagnostics.error(*said.coefficients_span, "a quadric needs a coefficient of x, y or z that is not 0");
    return std::nullopt;
  }
  return Quadric(coefficients);
}

}  // namespace

std::optional<Plane> make_plane(const parser::Plane& said, parser::Diagnostics& diagnostics) {
  const Vec3 normal = vector_or(said.normal, Vec3(0, 0, 1));
  if (is_zero(normal)) {
    diagnostics.error(said.normal->span, "the normal of a plane must not be zero");
    return std::nullopt;
  }
  return Plane(vector_or(said.point, Vec3(0)), normal);
}

std::optional<Torus> make_torus(const parser::Torus& said, parser::Diagnostics& diagnostics) {
  const double major = number_or(said.major_radius, 1), minor = number_or(said.minor_radius, 0.2);
  for (const auto& radius : {said.major_radius, said.minor_radius}) {
    if (!radius || radius->value > 0) continue;
    diagnostics.error(radius->span, "the radii of a torus must be greater than 0");
    return std::nullopt;
  }
  if (!std::isfinite(major + minor)) {
    diagnostics.error(said.major_radius->span, "the radii of a torus are too large");
    return std::nullopt;
  }
  return Torus(major, minor);
}

std::optional<Quadric> make_quadric(const parser::Quadric& said, parser::Diagnostics& diagnostics) {
  using Kind = parser::Quadric::Kind;
  switch (said.kind) {
    case Kind::paraboloid:
      return make_paraboloid(said, diagnostics);
    case Kind::hyperboloid:
      if (number_or(said.type_x, 0) != 0) return Quadric({-1, 1, 1, 0, 0, 0, 0, 0, 0, -1});
      return Quadric({1, 1, -1, 0, 0, 0, 0, 0, 0, -1});
    case Kind::hyperbolic:
      return Quadric({1, -1, -1, 0, 0, 0, 0, 0, 0, -1});
    case Kind::hyperbolic_paraboloid:
      return Quadric({1, -1, 0, 0, 0, 0, 0, 0, -1, 0});
    case Kind::general:
      break;
  }
  return make_general(said, diagnostics);
}

}  // namespace trace
