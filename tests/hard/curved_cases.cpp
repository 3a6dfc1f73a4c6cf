#include "tests/hard/curved_cases.hpp"

namespace trace::hard {

void add_curved_cases(std::vector<HardCase>& cases) {
  cases.push_back(far_sphere_case());
  cases.push_back(placed_sphere_case());
  cases.push_back(cylinder_case());
  cases.push_back(cone_case());
  cases.push_back(torus_case());
}

}  // namespace trace::hard
