// Which pixels a pilot looks at: a fixed choice, the same on every run and for any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>

namespace trace {

// Bits of a number, stirred (the finalizer of SplitMix64: Steele, Lea, Flood, "Fast Splittable Pseudorandom
// Number Generators", OOPSLA 2014).
inline std::uint64_t stirred(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// The place among `total` things of pilot number `index` of `count` <= total: one in each of as many equal
// parts.
inline std::size_t pilot_place(std::size_t index, std::size_t count, std::size_t total) {
  const std::size_t begin = index * total / count, end = (index + 1) * total / count;
  return begin + static_cast<std::size_t>(stirred(index) % (end - begin));
}

}  // namespace trace
