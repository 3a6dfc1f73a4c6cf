#include "tests/hard/hard_case.hpp"
#include "tests/hard/leaving_cases.hpp"

namespace trace::hard {

void add_leaving_cases(std::vector<HardCase>& cases) {
  cases.push_back(self_hit_case());
  cases.push_back(contact_case());
}

}  // namespace trace::hard
