// Where what belongs to the program is looked for.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace trace {

// `name` in the directory of the running program, then in ../lib/trace from there. Empty where the system
// does not tell which program runs.
std::vector<std::filesystem::path> places_beside_program(std::string_view name);

}  // namespace trace
