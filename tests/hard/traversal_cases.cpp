#include "tests/hard/hard_case.hpp"
#include "tests/hard/slab_cases.hpp"

namespace trace::hard {

void add_traversal_cases(std::vector<HardCase>& cases) {
  cases.push_back(slab_case());
}

}  // namespace trace::hard
