// Numbers that tests call by their names.
#pragma once

#include <limits>
#include <numbers>

namespace trace::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double pi = std::numbers::pi;

}  // namespace trace::test
