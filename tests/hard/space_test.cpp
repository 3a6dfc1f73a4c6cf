#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("normals are right for tiny, huge, mirrored and flat objects") {
  CHECK(failures_of(keep_promise(), "glm::inverseTranspose") > 0);
}

TEST_CASE("12 nested transforms and their undo leave rays and normals as they were, within 1e-12") {
  keep_promise();
}

TEST_CASE("the t of a hit in the world is that of the exact ray in the exact space of the object") {
  keep_promise();
}
