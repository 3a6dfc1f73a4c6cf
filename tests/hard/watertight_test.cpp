#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("no ray from inside a closed mesh gets out between its triangles") {
  CHECK(failures_of(keep_promise(), "textbook") > 0);
}

TEST_CASE("a triangle is hit exactly where exact arithmetic says so, whatever the order of its corners") {
  const std::vector<Row> rows = keep_promise();
  CHECK(failures_of(rows, "textbook") > 0);
  CHECK(failures_of(rows, "float") > 0);
}
