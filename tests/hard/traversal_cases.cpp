#include "tests/hard/hard_case.hpp"
#include "tests/hard/hierarchy_cases.hpp"
#include "tests/hard/slab_cases.hpp"

namespace trace::hard {

void add_traversal_cases(std::vector<HardCase>& cases) {
  cases.push_back(mesh_hierarchy_case());
  cases.push_back(scene_hierarchy_case());
  cases.push_back(slab_case());
  cases.push_back(coincident_case());
}

}  // namespace trace::hard
