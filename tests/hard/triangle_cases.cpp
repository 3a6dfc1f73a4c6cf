#include "tests/hard/hard_case.hpp"
#include "tests/hard/watertight_cases.hpp"

namespace trace::hard {

void add_triangle_cases(std::vector<HardCase>& cases) {
  cases.push_back(watertight_case());
  cases.push_back(edge_function_case());
}

}  // namespace trace::hard
