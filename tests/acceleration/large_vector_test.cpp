#include "acceleration/large_vector.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using namespace trace;

TEST_CASE("a large vector holds what was written, at sizes around those of pages") {
  const std::size_t size = GENERATE(0u, 1u, 1000u, 65536u, (2u << 20) - 4u, 2u << 20, (6u << 20) + 12u) / 4;
  LargeVector<std::uint32_t> numbers(size);
  CHECK(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64 == 0);
  std::iota(numbers.begin(), numbers.end(), 7u);
  numbers.push_back(static_cast<std::uint32_t>(size) + 7u);  // which moves them
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) wrong += numbers[i] != i + 7;
  CHECK(wrong == 0);
  CHECK(LargeVector<std::uint32_t>(3, 5u) == LargeVector<std::uint32_t>{5, 5, 5});
}
