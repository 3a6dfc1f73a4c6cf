// What a scene says in the dialects: rules that work where it is built.
#include "scene/dialect_rules.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"

using namespace trace;
using namespace trace::test;
using parser::Dialect;

namespace {

Describe description_in(Dialect dialect) {
  Describe description;
  description.scene.dialect = dialect;
  return description;
}

// One sphere of the last of these materials, after a default where there are two.
Rgb mirrored_by(Dialect dialect, const std::vector<parser::Material>& materials) {
  Describe description = description_in(dialect);
  if (materials.size() == 2) description.top(parser::Item(materials.front()));
  description.top(primitive(parser::Sphere{}, {materials.back()}));
  return build(description).material(0).reflective;
}

const Dialect with_mirrors[] = {Dialect::uw, Dialect::hkust};

Scene looking(Dialect dialect) {
  Describe description = description_in(dialect);
  parser::Camera camera;
  camera.viewdir = parser::Vector3{{0, 0, -3}, {}};
  camera.updir = parser::Vector3{{0, 2, 2}, {}};
  description.top(parser::Item(camera));
  return build(description).scene;
}

// The unit normals of its two faces are (0, 0, -1) and (1, 0, 0).
Vec3 generated_normal(Dialect dialect) {
  Describe description = description_in(dialect);
  parser::Mesh mesh;
  mesh.points = {0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1};
  mesh.corners = {0, 1, 2, 0, 1, 3};
  mesh.generate_normals = true;
  description.top(parser::Item(description.mesh(mesh)));
  return build(description).scene.meshes[0].geometry.normals[0];
}

}  // namespace

TEST_CASE("dialects have the names that options give them") {
  CHECK(dialect_named("uw") == Dialect::uw);
  CHECK(dialect_named("hkust") == Dialect::hkust);
  CHECK(dialect_named("utexas") == Dialect::utexas);
  CHECK_FALSE(dialect_named("UW"));
  CHECK(name_of(Dialect::hkust) == "hkust");
}

TEST_CASE("a scene is of utexas unless its description says otherwise, and has the rules of its dialect") {
  CHECK(build(Describe()).scene.rules == DialectRules());
  CHECK(build(description_in(Dialect::uw)).scene.rules == rules_of(Dialect::uw));
  CHECK(rules_of(Dialect::hkust).draws_as_utexas());
  CHECK_FALSE(rules_of(Dialect::uw).draws_as_utexas());
}

TEST_CASE("a material with specular and no reflective mirrors with it in uw and hkust, not in utexas") {
  const auto shiny = block({is(Parameter::specular, 0.5, 0.25, 1)});
  CHECK(mirrored_by(Dialect::utexas, {shiny}) == Rgb(0));
  for (const Dialect dialect : with_mirrors) CHECK(mirrored_by(dialect, {shiny}) == Rgb(0.5, 0.25, 1));
}

TEST_CASE("a reflective that is given counts in every dialect, in whatever order") {
  const auto first = block({is(Parameter::reflective, 0, 0, 0.5), is(Parameter::specular, 1, 1, 1)});
  const auto last = block({is(Parameter::specular, 1, 1, 1), is(Parameter::reflective, 0, 0, 0.5)});
  for (const Dialect dialect : {Dialect::utexas, Dialect::uw, Dialect::hkust}) {
    CHECK(mirrored_by(dialect, {first}) == Rgb(0, 0, 0.5));
    CHECK(mirrored_by(dialect, {last}) == Rgb(0, 0, 0.5));
  }
}

TEST_CASE("in uw and hkust a material inherits what mirrors until it gives specular itself") {
  const auto base = block({is(Parameter::specular, 0.5, 0.5, 0.5)});
  const auto neither = block({is(Parameter::diffuse, 1, 0, 0)});
  const auto own = block({is(Parameter::specular, 0.25, 0, 0)});
  for (const Dialect dialect : with_mirrors) {
    CHECK(mirrored_by(dialect, {base, neither}) == Rgb(0.5));
    CHECK(mirrored_by(dialect, {base, own}) == Rgb(0.25, 0, 0));
  }
}

TEST_CASE("the camera's vectors become orthonormal in uw and are used as they are in utexas") {
  const Scene uw = looking(Dialect::uw), utexas = looking(Dialect::utexas);
  CHECK(uw.camera.look == near(0, 0, -1));
  CHECK(uw.camera.right == near(1, 0, 0));
  CHECK(uw.camera.up == near(0, 1, 0));
  CHECK(utexas.camera.look == near(0, 0, -3));
  CHECK(utexas.camera.right == near(6, 0, 0));
  CHECK(utexas.camera.up == near(0, 2, 2));
}

TEST_CASE("normals from gennormals are of unit length in uw, and the mean of the faces' in utexas") {
  CHECK(generated_normal(Dialect::utexas) == near(0.5, 0, -0.5));
  CHECK(generated_normal(Dialect::uw) == near(std::sqrt(0.5), 0, -std::sqrt(0.5)));
}

TEST_CASE("cones have no habits in uw") {
  for (const Dialect dialect : {Dialect::utexas, Dialect::uw}) {
    Describe description = description_in(dialect);
    description.top(primitive(parser::Cone{}));
    const Scene scene = build(description).scene;
    // On the side of a pointed cone normals rise by half a right angle, or, twice too much, by more.
    LocalHit hit;
    REQUIRE(std::get<Cone>(scene.objects[0].shape).intersect({{5, 0, 0.5}, {-1, 0, 0}}, hit));
    CHECK(hit.normal.z / hit.normal.x == Approx(dialect == Dialect::uw ? 1 : 2).epsilon(1e-3));
  }
}
