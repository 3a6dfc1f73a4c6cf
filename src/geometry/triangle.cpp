#include "geometry/triangle.hpp"

#include <algorithm>

namespace trace {
namespace {

// Sizes between which no product of the fast test underflows or overflows in a way that matters: three edges
// or two and the way to the origin stay above 2^-900, where 2^-1074, what underflow may lose, is nothing
// against the bounds of meets().
constexpr double smallest_size = 0x1p-300, largest_size = 0x1p300;

}  // namespace

Triangle::Triangle(const Corners& corners)
    : a(corners.a),
      ab(corners.b - corners.a),
      ac(corners.c - corners.a),
      size(std::max(largest(ab), largest(ac))) {
  if (!(size >= smallest_size && size <= largest_size)) size = std::numeric_limits<double>::infinity();
}

}  // namespace trace
