// Transforms and groups: where objects end up.
#include "scene/graph.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const parser::Translate move_x{{1, 0, 0}};
const double quarter = std::acos(-1.0) / 2;

}  // namespace

TEST_CASE("the outer transform is applied last") {
  Describe d;
  // translate(1,0,0, scale(2, sphere)) and scale(2, translate(1,0,0, sphere)).
  d.top(d.element(move_x, {d.element(parser::Scale{{2, 2, 2}}, {d.element(primitive(parser::Sphere{}))})}));
  d.top(d.element(parser::Scale{{2, 2, 2}}, {d.element(move_x, {d.element(primitive(parser::Sphere{}))})}));
  const Built built = build(d);
  CHECK(built.place(0, {1, 0, 0}) == near(3, 0, 0));
  CHECK(built.place(1, {1, 0, 0}) == near(4, 0, 0));
}

TEST_CASE("a rotation is right-handed, in radians, about an axis of any length") {
  Describe d;
  for (const parser::Rotate& turn : {parser::Rotate{{0, 0, 5}, quarter}, parser::Rotate{{0, 1, 0}, quarter},
                                     parser::Rotate{{1, 1, 1}, 4 * quarter / 3}}) {
    d.top(d.element(turn, {d.element(primitive(parser::Box{}))}));
  }
  const Built built = build(d);
  CHECK(built.place(0, {1, 0, 0}) == near(0, 1, 0));
  CHECK(built.place(1, {0, 0, 1}) == near(1, 0, 0));
  CHECK(built.place(2, {1, 2, 3}) == near(3, 1, 2));  // a third of a turn: x to y to z to x
}

TEST_CASE("a transform is given row by row, and its fourth row does not move points") {
  Describe d;
  const parser::Transform rows{{{{1, 2, 3, 4}, {0, 1, 5, 6}, {0, 0, 1, 7}, {0, 0, 0, 1}}}};
  d.top(d.element(rows, {d.element(primitive(parser::Sphere{}))}));
  const Built built = build(d);
  CHECK(built.place(0) == near(4, 6, 7));
  CHECK(built.place(0, {1, 1, 1}) == near(10, 12, 8));
}

TEST_CASE("a group does not move what is in it, and transforms do not reach beyond their element") {
  Describe d;
  const auto first = d.element(move_x, {d.element(primitive(parser::Sphere{}))});
  const auto second = d.element(primitive(parser::Box{}));
  const auto third = d.element(parser::Translate{{0, 0, 9}}, {d.element(primitive(parser::Square{}))});
  d.top(d.element(parser::Translate{{0, 5, 0}}, {d.element(parser::Group{}, {first, second, third})}));
  d.top(primitive(parser::Cylinder{}));
  const Built built = build(d);
  REQUIRE(built.scene.objects.size() == 4);
  CHECK(built.place(0) == near(1, 5, 0));
  CHECK(built.place(1) == near(0, 5, 0));
  CHECK(built.place(2) == near(0, 5, 9));
  CHECK(built.place(3) == near(0, 0, 0));
}

TEST_CASE("objects are in the order of the file, whatever they are nested in") {
  Describe d;
  d.top(primitive(parser::Sphere{}));
  d.top(d.element(parser::Group{}, {d.element(move_x, {d.element(primitive(parser::Box{}))}),
                                    d.element(parser::Group{}, {d.element(primitive(parser::Square{}))}),
                                    d.element(primitive(parser::Cylinder{}))}));
  d.top(primitive(parser::Cone{}));
  const Built built = build(d);
  std::vector<std::size_t> kinds;
  for (const Object& object : built.scene.objects) kinds.push_back(object.shape.index());
  CHECK(kinds == std::vector<std::size_t>{0, 1, 2, 3, 4});
}

TEST_CASE("100 000 nested transforms and groups are walked without recursion") {
  Describe d;
  parser::ElementId inner = d.element(primitive(parser::Sphere{}));
  for (int i = 0; i < 50'000; ++i) inner = d.element(parser::Group{}, {d.element(move_x, {inner})});
  d.top(inner);
  const Built built = build(d);
  REQUIRE(built.scene.objects.size() == 1);
  CHECK(built.place(0) == Vec3(50'000, 0, 0));
}

TEST_CASE("a shape has its place's bounds in the world") {
  Describe d;
  d.top(d.element(parser::Translate{{10, 0, 0}},
                  {d.element(parser::Scale{{1, 2, -3}}, {d.element(primitive(parser::Cylinder{}))})}));
  const Built built = build(d);
  CHECK(built.scene.objects[0].bounds.min == near(9, -2, -3));
  CHECK(built.scene.objects[0].bounds.max == near(11, 2, 0));
}

TEST_CASE("what cannot be seen is left out: no scale, no axis, no faces") {
  Describe d;
  d.top(d.element(parser::Scale{{1, 0, 1}}, {d.element(primitive(parser::Sphere{}))}));
  d.top(d.element(parser::Rotate{{0, 0, 0}, 1}, {d.element(primitive(parser::Sphere{}))}));
  d.top(d.element(parser::Transform{{{{1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
                  {d.element(primitive(parser::Sphere{}))}));
  d.top(d.mesh(parser::Mesh{}));
  d.top(primitive(parser::Box{}));
  const Built built = build(d);
  REQUIRE(built.scene.objects.size() == 1);
  CHECK(std::holds_alternative<Box>(built.scene.objects[0].shape));
  CHECK_FALSE(built.diagnostics.has_errors());
}

TEST_CASE("20 000 nested rotations of every place and their undoing leave a sphere where it was") {
  Describe d;
  parser::ElementId inner = d.element(primitive(parser::Sphere{}));
  const auto turn = [](int i, double angle) { return parser::Rotate{{1.0 + i % 7, 2, 3.0 - i % 11}, angle}; };
  for (int i = 0; i < 10'000; ++i) inner = d.element(turn(i, -1e-3), {inner});
  for (int i = 9'999; i >= 0; --i) inner = d.element(turn(i, 1e-3), {inner});
  d.top(inner);
  const Built built = build(d);
  REQUIRE(built.scene.objects.size() == 1);
  const Frame& frame = built.scene.frames[0];
  CHECK(frame.error(1) < 1e-10);
  for (const Vec3& p : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0, 0.8)}) {
    CHECK(Vec3(frame.to_object * Vec4(p, 1)) == near(p, frame.error(1)));
  }
}

TEST_CASE("objects of one place share a frame, in whatever groups they are") {
  Describe d;
  d.top(d.element(move_x, {d.element(parser::Group{},
                                     {d.element(parser::Group{}, {d.element(primitive(parser::Box{}))}),
                                      d.element(primitive(parser::Sphere{})),
                                      d.element(parser::Group{}, {d.element(primitive(parser::Box{}))})})}));
  d.top(primitive(parser::Sphere{}));
  const Scene scene = build(d).scene;
  REQUIRE(scene.objects.size() == 4);
  CHECK(scene.frames.size() == 2);
  CHECK(scene.objects[0].frame == scene.objects[1].frame);
  CHECK(scene.objects[0].frame == scene.objects[2].frame);
  CHECK(scene.objects[0].frame != scene.objects[3].frame);
}

TEST_CASE("a sphere scaled by 1e-110 is there") {
  Describe d;
  d.top(d.element(parser::Scale{{1e-110, 1e-110, 1e-110}}, {d.element(primitive(parser::Sphere{}))}));
  const Built built = build(d);
  REQUIRE(built.scene.objects.size() == 1);
  CHECK(built.diagnostics.all().empty());
}
