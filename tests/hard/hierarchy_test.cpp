#include <tbb/task_arena.h>

#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("the hierarchy of a mesh finds the face and the t of testing every face, bit for bit") {
  keep_promise();
}

TEST_CASE("the hierarchy of a scene finds the object and the t of testing every object, bit for bit") {
  keep_promise();
}

TEST_CASE("of surfaces in one place the first in the file is seen, however the hierarchy is built") {
  const std::vector<Row> on_all_cores = keep_promise();
  std::vector<Row> on_one;
  tbb::task_arena(1).execute([&] { on_one = keep_promise(); });
  REQUIRE(on_one.size() == on_all_cores.size());
  for (std::size_t i = 0; i < on_one.size(); ++i) CHECK(on_one[i].digest == on_all_cores[i].digest);
}
