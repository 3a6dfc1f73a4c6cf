// Pictures as parameters of materials.
#include "scene/material_maps.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// A folder with one picture, 2 x 1: left (51, 102, 204), right (255, 255, 255).
class Folder {
 public:
  Folder() { write_image(directory_ / "map.png", Image{2, 1, {51, 102, 204, 255, 255, 255}}); }
  std::string path() const { return directory_.path().string(); }

 private:
  TemporaryFolder directory_;
};

const Rgb left(0.2, 0.4, 0.8);

Built built_of(const Folder& folder, PrimitiveShape shape,
               std::vector<parser::MaterialAssignment> assignments,
               std::vector<parser::MaterialAssignment> inherited = {}) {
  Describe d;
  d.top(block(std::move(inherited)));
  d.top(primitive(shape, {block(std::move(assignments))}));
  return build(d, folder.path());
}

Material seen(const Built& built, const Vec2& uv) {
  return at_point(built.scene.materials[built.scene.objects[0].material], built.scene.textures, uv);
}

}  // namespace

TEST_CASE("a map is the value of its parameter at each point of a box or square") {
  const Folder folder;
  const PrimitiveShape shape = GENERATE(PrimitiveShape(parser::Box{}), PrimitiveShape(parser::Square{}));
  const Built built =
      built_of(folder, shape, {is_map(Parameter::diffuse, "map.png"), is(Parameter::ambient, 1, 2, 3)},
               {is(Parameter::diffuse, 0.5, 0.5, 0.5)});
  REQUIRE_FALSE(built.diagnostics.has_errors());
  CHECK(seen(built, {0, 0}).diffuse == near(left));
  CHECK(seen(built, {1, 0}).diffuse == near(1, 1, 1));
  CHECK(seen(built, {0.5, 0}).diffuse == near(0.6, 0.7, 0.9));
  CHECK(seen(built, {0.5, 0}).ambient == Rgb(1, 2, 3));
}

TEST_CASE("every parameter but reflective and transmissive can be a map") {
  const Folder folder;
  const Built built = built_of(folder, parser::Square{},
                               {is_map(Parameter::emissive, "map.png"), is_map(Parameter::ambient, "map.png"),
                                is_map(Parameter::specular, "map.png"), is_map(Parameter::index, "map.png"),
                                is_map(Parameter::shininess, "map.png")});
  const Material m = seen(built, {0, 0});
  CHECK(m.emissive == near(left));
  CHECK(m.ambient == near(left));
  CHECK(m.specular == near(left));
  const double grey = 0.299 * 0.2 + 0.587 * 0.4 + 0.114 * 0.8;
  CHECK(luminance(m.index) == about(grey));
  CHECK(luminance(m.shininess) == about(128 * grey));
}

TEST_CASE("a surface without texture coordinates shows the lower left texel everywhere") {
  const Folder folder;
  const PrimitiveShape shape = GENERATE(PrimitiveShape(parser::Sphere{}), PrimitiveShape(parser::Cylinder{}),
                                        PrimitiveShape(parser::Cone{}));
  const Built built = built_of(folder, shape, {is_map(Parameter::diffuse, "map.png")});
  CHECK(built.material(0).diffuse == near(left));
}

TEST_CASE("a mesh and its points show the lower left texel of their maps") {
  const Folder folder;
  Describe d;
  const auto map = block({is_map(Parameter::diffuse, "map.png")});
  d.top(d.mesh(triangle_mesh({block({}), map, block({is(Parameter::diffuse, 1, 1, 1)})}), {map}, 1));
  const Built built = build(d, folder.path());
  CHECK(built.material(0).diffuse == near(left));
  REQUIRE(built.scene.meshes[0].materials.size() == 3);
  CHECK(built.scene.meshes[0].materials[0].diffuse == near(left));  // inherited
  CHECK(built.scene.meshes[0].materials[1].diffuse == near(left));
  CHECK(built.scene.meshes[0].materials[2].diffuse == Rgb(1));
}

TEST_CASE("a later constant replaces a map, a later map a constant") {
  const Folder folder;
  const auto map = is_map(Parameter::diffuse, "map.png");
  const auto constant = is(Parameter::diffuse, 0, 1, 0);
  CHECK(seen(built_of(folder, parser::Square{}, {map, constant}), {1, 1}).diffuse == Rgb(0, 1, 0));
  CHECK(seen(built_of(folder, parser::Square{}, {constant}, {map}), {1, 1}).diffuse == Rgb(0, 1, 0));
  CHECK(seen(built_of(folder, parser::Square{}, {constant, map}), {1, 1}).diffuse == near(1, 1, 1));
  CHECK(seen(built_of(folder, parser::Square{}, {}, {map}), {1, 1}).diffuse == near(1, 1, 1));
}

TEST_CASE("a map for reflective or transmissive has no effect, and a warning says so") {
  const Folder folder;
  const Parameter parameter = GENERATE(Parameter::reflective, Parameter::transmissive);
  const Built built =
      built_of(folder, parser::Square{}, {is_map(parameter, "map.png")}, {is(parameter, 1, 1, 1)});
  const Material m = seen(built, {1, 1});
  CHECK_FALSE(m.reflects());
  CHECK_FALSE(m.transmits());
  CHECK_FALSE(built.diagnostics.has_errors());
  REQUIRE(built.diagnostics.all().size() == 1);
  const parser::Diagnostic& warning = built.diagnostics.all()[0];
  CHECK(warning.severity == parser::Severity::warning);
  CHECK(warning.span == parser::Span{10, 30});
  CHECK(warning.text == (parameter == Parameter::reflective
                             ? "a map for 'reflective' has no effect: the surface stays without reflection"
                             : "a map for 'transmissive' has no effect: the surface stays opaque"));
}

TEST_CASE("a texture that cannot be read is one error, at its file's place, with the reason") {
  const Folder folder;
  const Built missing = built_of(folder, parser::Square{}, {is_map(Parameter::diffuse, "nope.png")});
  REQUIRE(missing.diagnostics.error_count() == 1);
  CHECK(missing.diagnostics.all()[0].text == "cannot read texture 'nope.png': no such file");
  CHECK(missing.diagnostics.all()[0].span == parser::Span{20, 30});
  const Built other = built_of(folder, parser::Sphere{}, {is_map(Parameter::shininess, "scene.ray")});
  REQUIRE(other.diagnostics.error_count() == 1);
  CHECK(other.diagnostics.all()[0].text ==
        "cannot read texture 'scene.ray': not a picture this program can read");
}

TEST_CASE("the texture of a mesh's own material is complained about once, though its points inherit it") {
  const Folder folder;
  Describe d;
  d.top(d.mesh(triangle_mesh({block({}), block({}), block({})}),
               {block({is_map(Parameter::diffuse, "nope.png")})}, 1));
  CHECK(build(d, folder.path()).diagnostics.error_count() == 1);
}

TEST_CASE("a global material's texture is complained about even if no object uses it") {
  const Folder folder;
  Describe d;
  d.top(block({is_map(Parameter::diffuse, "nope.png")}));
  CHECK(build(d, folder.path()).diagnostics.error_count() == 1);
}

TEST_CASE("a picture that several materials name is opened once") {
  const Folder folder;
  Describe d;
  for (int i = 0; i < 3; ++i) {
    d.top(primitive(parser::Box{},
                    {block({is_map(Parameter::diffuse, "map.png"), is_map(Parameter::ambient, "map.png")})}));
  }
  CHECK(build(d, folder.path()).scene.textures.size() == 1);
}
