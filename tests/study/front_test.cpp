// Which settings are worth their time.
#include "study/front.hpp"

#include <catch2/catch.hpp>

namespace trace::test {

TEST_CASE("a setting is on the front unless another is at least as good in both and better in one") {
  const std::vector<Cost> costs{{1, 9}, {2, 5}, {3, 5}, {2, 6}, {4, 1}, {5, 2}, {0.5, 20}};
  CHECK(pareto_front(costs) == std::vector<bool>{true, true, false, false, true, false, true});
}

TEST_CASE("equal settings are both on the front or neither") {
  const std::vector<Cost> costs{{1, 2}, {1, 2}, {3, 3}, {3, 3}};
  CHECK(pareto_front(costs) == std::vector<bool>{true, true, false, false});
}

TEST_CASE("one setting alone is its front, and of none there is none") {
  CHECK(pareto_front(std::vector<Cost>{{7, 7}}) == std::vector<bool>{true});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("of those within an error the fastest counts, the first of equally fast ones") {
  const std::vector<Cost> costs{{1, 9}, {3, 2}, {2, 4}, {2, 3}, {9, 0}};
  CHECK(fastest_within(costs, 10) == 0);
  CHECK(fastest_within(costs, 4) == 2);
  CHECK(fastest_within(costs, 3.9) == 3);
  CHECK(fastest_within(costs, 2) == 1);
  CHECK(fastest_within(costs, 0) == 4);
  CHECK(fastest_within(costs, -1) == -1);
  CHECK(fastest_within({}, 100) == -1);
}

}  // namespace trace::test
