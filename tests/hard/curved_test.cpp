#include "tests/hard/keep_promise.hpp"

using namespace trace::hard;

TEST_CASE("a sphere is hit or missed as its line says, however far away") {
  CHECK(failures_of(keep_promise(), "textbook") > 0);
}

TEST_CASE("a sphere of radius 1e-6 is hit or missed at a distance of 100") {
  CHECK(failures_of(keep_promise(), "textbook") > 0);
}

TEST_CASE("a cylinder is hit or missed as its line says, along the axis, at the rim and from far away") {
  CHECK(failures_of(keep_promise(), "textbook") > 0);
}

TEST_CASE(
    "a cone is hit or missed as the course's rules say, along its lines, at its apex and from far away") {
  CHECK(failures_of(keep_promise(), "textbook") > 0);
}

TEST_CASE("a torus is hit or missed as its line says, touching it, along its axis and from far away") {
  CHECK(failures_of(keep_promise(), "textbook") > 0);
}
