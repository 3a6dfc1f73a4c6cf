#include "tests/metamorphic/retold.hpp"
#include "tests/hard/keep_promise.hpp"
#include "tests/metamorphic/scenes.hpp"

using namespace trace;
using namespace trace::hard;

TEST_CASE("a room moved far away with its camera and light gives the same picture") {
  keep_promise();
}

TEST_CASE("a scene moved, scaled, turned, mirrored, regrouped, reordered or refaced gives the same picture") {
  keep_promise();
}

TEST_CASE("pictures of scenes that are not the same differ") {
  // So that the comparisons above can fail: the camera stays where it was.
  const test::SceneText scene = test::shadows_scene();
  test::Retelling lifted;
  lifted.opening = "translate(0, 0.2, 0, ";
  const Image plain = test::picture(scene, {}, 32);
  CHECK(test::compare(plain, test::picture(scene, lifted, 32), false).off > 32);
  CHECK(test::compare(plain, plain, true).off > 32);
}
