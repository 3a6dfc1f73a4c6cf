#include "scene/singular_reason.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trace {
namespace {

struct Reason {
  std::string word;    // the transform's
  std::string itself;  // what is wrong with the transform alone; empty where nothing is
};

Reason reason(const parser::Scale& scale) {
  std::string axes;
  const auto zeros = std::count(scale.factors.begin(), scale.factors.end(), 0.0);
  if (zeros == 3) return {"scale", "it scales by 0"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (scale.factors[axis] == 0) axes += fmt::format("{}{}", axes.empty() ? "" : " and ", "xyz"[axis]);
  }
  if (zeros == 0) return {"scale", ""};
  return {"scale", fmt::format("its {} for {} {} 0", zeros == 1 ? "factor" : "factors", axes,
                               zeros == 1 ? "is" : "are")};
}

Reason reason(const parser::Rotate& rotate) {
  const bool no_axis = rotate.axis == std::array<double, 3>{};
  return {"rotate", no_axis ? "the axis (0, 0, 0) is no direction" : ""};
}

Reason reason(const parser::Transform& transform) {
  Mat4 m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) m[column][row] = transform.rows[row][column];
  }
  return {"transform", reliable(bounded_inverse(m), m) ? "" : "its matrix has no inverse"};
}

Reason reason(const parser::Translate&) {
  return {"translate", ""};
}

template <class Other>
Reason reason(const Other&) {
  return {};
}

}  // namespace

std::string singular_reason(const decltype(parser::Element::what)& what, const Placement& place) {
  Reason found = std::visit([](const auto& w) { return reason(w); }, what);
  if (found.itself.empty()) {
    found.itself = "with the transforms around it, ";
    if (!is_finite(place.to_world())) {
      found.itself += "it makes numbers too large for double precision";
    } else if (!is_finite(place.to_object().value)) {
      found.itself += "it makes things too small for double precision";
    } else {
      found.itself += "it makes a matrix that has no inverse";
    }
  }
  return fmt::format("nothing inside this {} is drawn: {}", found.word, found.itself);
}

}  // namespace trace
