// Equality of what scalar code and packets compute.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <string>
#include <vector>

#include "tests/packets/kernels.hpp"
#include "tests/support/numbers_near.hpp"

namespace trace::test {

// The same bits, or both not a number, of which IEEE 754 leaves the sign open.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}
inline bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}
inline bool same_bits(const Ray& a, const Ray& b) {
  return same_bits(a.origin, b.origin) && same_bits(a.direction, b.direction) &&
         same_bits(a.origin_error, b.origin_error) && same_bits(a.least_t, b.least_t);
}
inline bool same_bits(const LocalHit& a, const LocalHit& b) {
  return same_bits(a.t, b.t) && same_bits(a.normal, b.normal) && same_bits(a.uv.x, b.uv.x) &&
         same_bits(a.uv.y, b.uv.y) && a.part == b.part;
}

inline std::string shown(const Ray& ray) {
  std::ostringstream text;
  text.precision(17);
  text << "origin " << shown(ray.origin) << ", direction " << shown(ray.direction) << ", error "
       << ray.origin_error << ", least t " << ray.least_t;
  return text.str();
}

// Calls visit(packet, first) for packets of a list in turn.
template <class T, class Visit>
void for_each_packet(const std::vector<T>& list, std::size_t lanes, Visit&& visit) {
  for (std::size_t i = 0; i < list.size(); i += lanes) {
    visit(std::span<const T>(list).subspan(i, std::min(lanes, list.size() - i)), i);
  }
}

inline unsigned all_of(std::size_t count) {
  return (1u << count) - 1;
}

}  // namespace trace::test
