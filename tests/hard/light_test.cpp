#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("within ulps of the critical angle a ray is either refracted or totally reflected") {
  keep_promise();
}

TEST_CASE("a smooth mesh of few faces keeps the course's shadow terminator") {
  // A correction would change what is seen.
  CHECK(failures_of(keep_promise(), "corrected") > 0);
}

TEST_CASE("where a light, a view or a power is undefined the colour is that of a rule, not NaN") {
  keep_promise();
}
