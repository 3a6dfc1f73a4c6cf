// docs/language.md section 2: what is not assigned is inherited.
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const auto red = is(Parameter::diffuse, 1, 0, 0);
const auto green = is(Parameter::diffuse, 0, 1, 0);
const auto glow = is(Parameter::emissive, 0, 0, 1);
const auto shiny = is(Parameter::shininess, 20);

parser::Primitive sphere(std::vector<parser::Material> materials = {}) {
  return primitive(parser::Sphere{}, std::move(materials));
}

}  // namespace

TEST_CASE("a material that says nothing is black, dull and of index one") {
  Describe d;
  d.top(sphere());
  const Material m = build(d).material(0);
  for (const Rgb& c :
       {m.emissive, m.ambient, m.diffuse, m.specular, m.reflective, m.transmissive, m.shininess}) {
    CHECK(c == Rgb(0));
  }
  CHECK(m.index == Rgb(1));
}

TEST_CASE("a global material holds for what follows it, and only that") {
  Describe d;
  d.top(sphere());
  d.top(block({red, shiny}));
  d.top(sphere());
  d.top(block({glow}));  // starts from the previous global one
  d.top(sphere({block({green})}));
  d.top(sphere());
  const Built built = build(d);
  CHECK(built.material(0).diffuse == Rgb(0));
  CHECK(built.material(1).diffuse == Rgb(1, 0, 0));
  CHECK(built.material(1).emissive == Rgb(0));
  CHECK(built.material(2).diffuse == Rgb(0, 1, 0));
  CHECK(built.material(2).emissive == Rgb(0, 0, 1));
  CHECK(built.material(2).shininess == Rgb(20));
  CHECK(built.material(3).diffuse == Rgb(1, 0, 0));
}

TEST_CASE("reflection is not derived from the specular colour") {
  Describe d;
  d.top(sphere({block({is(Parameter::specular, 1, 1, 1)})}));
  CHECK_FALSE(build(d).material(0).reflects());
}

TEST_CASE("a second material of one object replaces the first and starts from the inherited one again") {
  Describe d;
  d.top(block({shiny}));
  d.top(sphere({block({red, glow}), block({is(Parameter::ambient, 0.5, 0.5, 0.5)})}));
  const Material m = build(d).material(0);
  CHECK(m.diffuse == Rgb(0));
  CHECK(m.emissive == Rgb(0));
  CHECK(m.ambient == Rgb(0.5));
  CHECK(m.shininess == Rgb(20));
}

TEST_CASE("of two assignments of one parameter the last counts") {
  Describe d;
  d.top(sphere({block({red, glow, green})}));
  CHECK(build(d).material(0).diffuse == Rgb(0, 1, 0));
}

TEST_CASE("a material in a group holds up to the group's end, and groups within start from it") {
  Describe d;
  d.top(block({shiny}));
  const auto before = d.element(sphere());
  const auto set = d.element(block({red}));
  const auto after = d.element(sphere());
  const auto inner_set = d.element(block({glow}));
  const auto inner = d.element(parser::Group{}, {inner_set, d.element(sphere())});
  const auto last = d.element(sphere());
  d.top(d.element(parser::Group{}, {before, set, after, inner, last}));
  d.top(sphere());
  const Built built = build(d);
  REQUIRE(built.scene.objects.size() == 5);
  CHECK(built.material(0).diffuse == Rgb(0));
  CHECK(built.material(1).diffuse == Rgb(1, 0, 0));
  CHECK(built.material(1).shininess == Rgb(20));
  CHECK(built.material(2).diffuse == Rgb(1, 0, 0));
  CHECK(built.material(2).emissive == Rgb(0, 0, 1));
  CHECK(built.material(3).diffuse == Rgb(1, 0, 0));
  CHECK(built.material(3).emissive == Rgb(0));
  CHECK(built.material(4).diffuse == Rgb(0));
}

TEST_CASE("a name stands for the whole material it was given to, inherited parameters included") {
  Describe d;
  d.top(block({shiny}));
  d.top(sphere({block_named("brick", {red})}));
  d.top(block({glow, is(Parameter::shininess, 3)}));
  d.top(sphere({named("brick")}));
  const Material m = build(d).material(1);
  CHECK(m.diffuse == Rgb(1, 0, 0));
  CHECK(m.shininess == Rgb(20));
  CHECK(m.emissive == Rgb(0));
}

TEST_CASE("a name can be given in a group and used as the global material") {
  Describe d;
  d.top(d.element(parser::Group{}, {d.element(block_named("a", {red})), d.element(sphere())}));
  d.top(named("a"));
  d.top(sphere());
  CHECK(build(d).material(1).diffuse == Rgb(1, 0, 0));
}

TEST_CASE("materials of points inherit from the mesh's material as it stood before their list") {
  const std::vector<parser::Material> points{block({}), block({green}), block({glow})};
  const std::size_t before = GENERATE(0, 1, 2);
  Describe d;
  d.top(block({shiny}));
  d.top(d.mesh(triangle_mesh(points), {block({red}), block({is(Parameter::diffuse, 0, 0, 1)})}, before));
  const Built built = build(d);
  REQUIRE(built.scene.meshes.size() == 1);
  const std::vector<Material>& m = built.scene.meshes[0].materials;
  REQUIRE(m.size() == 3);
  const Rgb inherited = before == 0 ? Rgb(0) : before == 1 ? Rgb(1, 0, 0) : Rgb(0, 0, 1);
  CHECK(m[0].diffuse == inherited);
  CHECK(m[1].diffuse == Rgb(0, 1, 0));
  CHECK(m[2].diffuse == inherited);
  CHECK(m[2].emissive == Rgb(0, 0, 1));
  CHECK(m[0].shininess == Rgb(20));
  CHECK(built.material(0).diffuse == Rgb(0, 0, 1));  // the object's own is the last
}

TEST_CASE("a scene knows whether light can pass any object") {
  Describe opaque;
  opaque.top(block({is(Parameter::transmissive, 1, 1, 1)}));
  opaque.top(sphere({block({is(Parameter::transmissive, 0, 0, 0)})}));
  CHECK_FALSE(build(opaque).scene.has_transmissive_objects);
  Describe glass;
  glass.top(sphere({block({is(Parameter::transmissive, 0, 0.1, 0)})}));
  CHECK(build(glass).scene.has_transmissive_objects);
  Describe mesh;
  mesh.top(mesh.mesh(triangle_mesh({block({}), block({is(Parameter::transmissive, 1, 1, 1)}), block({})})));
  CHECK(build(mesh).scene.has_transmissive_objects);
}
