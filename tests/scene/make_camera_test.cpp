#include "scene/make_camera.hpp"

#include <catch2/catch.hpp>

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

parser::Vector3 at(double x, double y, double z) {
  return {{x, y, z}, {10, 20}};
}

Camera camera_of(const std::vector<parser::Camera>& blocks) {
  parser::Diagnostics diagnostics;
  CameraMaker maker(diagnostics);
  for (const parser::Camera& block : blocks) maker.add(block);
  const Camera camera = maker.take();
  CHECK(diagnostics.all().empty());
  return camera;
}

std::string complaint(const parser::Camera& block) {
  parser::Diagnostics diagnostics;
  CameraMaker maker(diagnostics);
  maker.add(block);
  maker.take();
  REQUIRE(diagnostics.all().size() == 1);
  return diagnostics.all()[0].text;
}

}  // namespace

TEST_CASE("a camera looks at a point upright, from where the last block puts it") {
  parser::Camera look, place;
  look.look_at = at(0, 0, -4);
  place.position = at(3, 0, 0);
  const Camera camera = camera_of({look, place});
  CHECK(camera.look == near(-0.6, 0, -0.8));
  CHECK(camera.up == near(0, 1, 0));
  CHECK(camera.right == near(0.8, 0, -0.6));
}

TEST_CASE("a camera that looks along y has x upward, and one with an up direction has that") {
  parser::Camera block;
  block.look_at = at(0, -5, 0);
  CHECK(camera_of({block}).up == Vec3(1, 0, 0));
  block.updir = at(0, 0, 2);
  CHECK(camera_of({block}).up == Vec3(0, 0, 2));
}

TEST_CASE("a later direction replaces the point that a camera looks at") {
  parser::Camera look, view;
  look.look_at = at(0, 0, 9);
  view.viewdir = at(1, 0, 0);
  view.updir = at(0, 1, 0);
  CHECK(camera_of({look, view}).look == Vec3(1, 0, 0));
  CHECK(camera_of({view, look}).look == near(0, 0, 1));
}

TEST_CASE("the rays of an orthographic camera are parallel and fill its height") {
  parser::Camera block;
  block.position = at(1, 2, 3);
  block.viewdir = at(0, 0, -7);
  block.updir = at(0, 3, 0);
  block.aspectratio = parser::Scalar{2, {}};
  block.orthographic = parser::Located<bool>{true, {}};
  block.height = parser::Scalar{6, {}};
  const RayCaster caster(camera_of({block}));
  CHECK(caster.cast(0.5, 0.5).origin == Vec3(1, 2, 3));
  const Ray corner = caster.cast(0, 1);
  CHECK(corner.direction == Vec3(0, 0, -1));
  CHECK(corner.origin == near(-5, 5, 3));
  const Ray in_parts = caster.cast(caster.across(0), caster.upward(1));
  CHECK(in_parts.origin == corner.origin);
}

TEST_CASE("without a height an orthographic camera sees what its perspective does at distance one") {
  parser::Camera block;
  block.fov = parser::Scalar{90, {}};
  block.orthographic = parser::Located<bool>{true, {}};
  CHECK(*camera_of({block}).orthographic_height == Approx(2));
}

TEST_CASE("what a camera cannot look at or show is complained of") {
  parser::Camera block;
  block.look_at = at(0, 0, 0);
  CHECK(complaint(block) == "'look_at' is where the camera is");
  block.look_at.reset();
  block.height = parser::Scalar{2, {}};
  CHECK(complaint(block) == "'height' has no effect: the camera is not orthographic");
  block.orthographic = parser::Located<bool>{true, {}};
  block.height = parser::Scalar{0, {}};
  CHECK(complaint(block) == "'height' must be greater than 0");
}
