#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("a ray that leaves a convex solid does not meet it again, and one that enters meets its far side") {
  CHECK(failures_of(keep_promise(), "fixed epsilon 1e-8") > 0);
}

TEST_CASE("what is 1e-6 of its size above a surface keeps its shadow, at every scale") {
  CHECK(failures_of(keep_promise(), "fixed epsilon 1e-8") > 0);
}
