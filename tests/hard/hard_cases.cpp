#include <stdexcept>

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> cases;
  add_triangle_cases(cases);
  add_traversal_cases(cases);
  add_leaving_cases(cases);
  add_curved_cases(cases);
  add_space_cases(cases);
  add_picture_cases(cases);
  add_light_cases(cases);
  std::stable_sort(cases.begin(), cases.end(),
                   [](const HardCase& a, const HardCase& b) { return a.row < b.row; });
  return cases;
}

HardCase hard_case(std::string_view name) {
  for (const HardCase& c : hard_cases()) {
    if (c.name == name) return c;
  }
  throw std::invalid_argument("no hard case is named \"" + std::string(name) + '"');
}

}  // namespace trace::hard
