#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("a ray through a point of a closed box, flat or not, is handed what the box holds") {
  const std::vector<Row> rows = keep_promise();
  CHECK(failures_of(rows, "min/max slabs") > 0);
  CHECK(failures_of(rows, "glm::min/max slabs") > 0);
}
