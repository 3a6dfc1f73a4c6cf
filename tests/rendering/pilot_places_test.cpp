// Which pixels a pilot looks at.
#include "rendering/pilot_places.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace trace;

TEST_CASE("a pilot looks at one place in each of as many equal parts") {
  for (const std::size_t total : {1u, 2u, 7u, 640u, 4097u, 262144u}) {
    for (const std::size_t count : {1u, 2u, 7u, 24u, 640u}) {
      if (count > total) continue;
      INFO(count << " of " << total);
      int outside = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = pilot_place(k, count, total);
        outside += place < k * total / count || place >= (k + 1) * total / count;
      }
      CHECK(outside == 0);
    }
  }
}

TEST_CASE("places do not lie on a grid that a picture's own could meet") {
  // 64 pixels of 4096: at equal distances all would be in one column of a picture 64 wide.
  std::set<std::size_t> columns;
  for (std::size_t k = 0; k < 64; ++k) columns.insert(pilot_place(k, 64, 4096) % 64);
  CHECK(columns.size() > 32);
}
