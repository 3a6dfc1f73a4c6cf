// The words of dialects: where they count, what is read of them, and what is refused by name.
#include <catch2/catch.hpp>

#include "helpers.hpp"

using namespace trace::parser;
using namespace trace::parser::test;

namespace {

// As messages(), reading on past what is not known.
std::string permissive_messages(const std::string& body) {
  const Source source = Source::from_text("scene.ray", header + body);
  Diagnostics diagnostics;
  ParseOptions options;
  options.permissive = true;
  parse(source, diagnostics, options);
  std::string result;
  for (const Diagnostic& d : diagnostics.all()) {
    result += (d.severity == Severity::error ? "error: " : "warning: ") + d.text + "\n";
  }
  return result;
}

template <class T>
T only(const std::string& body) {
  const Scene scene = scene_of(header + body);
  REQUIRE(scene.items.size() == 1);
  return std::get<T>(scene.items.front());
}

Primitive only_primitive(const std::string& body) {
  const Scene scene = scene_of(header + body);
  REQUIRE(scene.elements.size() == 1);
  return std::get<Primitive>(scene.elements.front().what);
}

}  // namespace

TEST_CASE("words of dialects are names like others where nothing of theirs begins") {
  CHECK(*only_primitive("sphere { name = torus; }").name->value.begin() == 't');
  CHECK(only_primitive("box { name = fog material = { diffuse = (1,0,0) } }").materials.size() == 1);
  CHECK(messages("material = { name plane; } sphere { material = plane; }").empty());
  CHECK(messages("material = { name = bump; diffuse = (1,1,1); } sphere { material = bump }").empty());
}

TEST_CASE("a material is named and used in every spelling the dialects have") {
  for (const char* definition : {"material = { name \"a b\"; }", "material = { name = \"a b\"; }",
                                 "material { name = \"a b\"; index = 2; }", "material { name=\"a b\" }"}) {
    INFO(definition);
    CHECK(messages(std::string(definition) + " sphere { material = \"a b\"; }").empty());
    CHECK(messages(std::string(definition) + " { material = \"a b\" sphere {} }").empty());
  }
  CHECK(messages("material { name = gold; } box { material = gold }").empty());
  CHECK(messages("sphere { material = gold; }") ==
        "2:21: error: there is no material named 'gold' before this\n");
}

TEST_CASE("a comma may stand behind the last entry of a list") {
  const Scene scene = scene_of(
      header +
      "trimesh { points=((0,0,0),(1,0,0),(0,1,0),); normals=((0,0,1),(0,0,1),(0,0,1),); faces=((0,1,2),);"
      " texture_uv=((0,0),(1,0),(0,1),); materials=({},{index=2},{},); }");
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].points.size() == 9);
  CHECK(scene.meshes[0].normals.size() == 9);
  CHECK(scene.meshes[0].corners.size() == 3);
  CHECK(scene.meshes[0].texture_coordinates == std::vector<double>{0, 0, 1, 0, 0, 1});
  CHECK(scene.meshes[0].vertex_materials.count() == 3);
  CHECK(messages("trimesh { materials=({},,{}); }") == "2:25: error: expected a material, found ','\n");
}

TEST_CASE("gennormals takes true or false, too") {
  CHECK(scene_of(header + "trimesh { gennormals=true; }").meshes[0].generate_normals);
  CHECK(scene_of(header + "trimesh { gennormals=true }").meshes[0].generate_normals);
  CHECK_FALSE(scene_of(header + "trimesh { gennormals=false; }").meshes[0].generate_normals);
}

TEST_CASE("a camera looks at a point, or sees in parallel") {
  const Camera camera = only<Camera>(
      "camera { position=(1,2,3); look_at=(4,5,6); updir=(0,0,1); projection=orthographic; height=7; }");
  CHECK(camera.look_at->value == std::array<double, 3>{4, 5, 6});
  CHECK(camera.updir->value == std::array<double, 3>{0, 0, 1});
  CHECK(camera.orthographic->value);
  CHECK(camera.height->value == 7);
  CHECK_FALSE(only<Camera>("camera { projection=perspective; }").orthographic->value);
  CHECK(only<Camera>("camera { quaternion=(1,2,3,4); }").quaternion->value[3] == 4);
  CHECK(messages("camera { look_at=(0,0,0); viewdir=(0,0,1); updir=(0,1,0); }") ==
        "2:10: error: the camera gives both 'viewdir' and 'look_at'\n");
  CHECK(messages("camera { projection=isometric; height=0; }") ==
        "2:21: error: unknown projection 'isometric': write perspective or orthographic\n"
        "2:39: error: the 'height' of a camera must be greater than 0\n");
}

TEST_CASE("what no parser ever used is warned of") {
  CHECK(messages("camera { focaldistance = 13.6; fov = 30; }") ==
        "2:10: warning: 'focaldistance' has no effect in the camera\n");
  CHECK(messages("point_light { position=(0,0,0); color=(1,1,1); angle=0.5; central_direction=(1,2,3); }") ==
        "2:48: warning: 'angle' has no effect in a point_light\n"
        "2:59: warning: 'central_direction' has no effect in a point_light\n");
}

TEST_CASE("the lights of dialects are read as they are written") {
  const DialectLight spot = only<DialectLight>(
      "spot_light { position=(1,2,3); colour=(1,1,1); target=(0,0,0); cone_angle=30; penumbra=10;"
      " constant_attenuation_coeff=0.5; }");
  CHECK(spot.kind == DialectLight::Kind::spot);
  CHECK(spot.word == "spot_light");
  REQUIRE(spot.attributes.size() == 6);
  CHECK(std::get<double>(spot.find("cone_angle")->value) == 30);
  CHECK(std::get<std::array<double, 3>>(spot.find("color")->value)[0] == 1);
  CHECK(spot.find("edgeplace") == nullptr);
  using Kind = DialectLight::Kind;
  CHECK(only<DialectLight>("area_light { u=(1,0,0); v=(0,1,0); }").kind == Kind::area);
  CHECK(only<DialectLight>("area_light_rect { width=1; height=2; updir=(0,1,0); }").kind ==
        Kind::area_rectangle);
  CHECK(only<DialectLight>("area_light_circ { radius=1; }").kind == Kind::area_disc);
  CHECK(only<DialectLight>("shape_light { parms=(1,2,3); up=(0,0,1); }").kind == Kind::shape);
  CHECK(only<DialectLight>("warn_light { flap_0=(1,2,3); type=3; }").kind == Kind::warn);
  CHECK(only<DialectLight>("warn_model_light { xflapmin=-1; }").kind == Kind::warn_model);
  CHECK(messages("spot_light { angle=1; angle=2; xflap=3; }") ==
        "2:23: error: 'angle' is given twice in this spot_light\n"
        "2:14: note: first given here\n"
        "2:32: error: unknown attribute 'xflap' in a spot_light\n"
        "2:32: note: a spot_light takes position, direction, color, constant_attenuation_coeff, "
        "linear_attenuation_coeff, quadratic_attenuation_coeff, target, angle, inner_angle and exponent\n");
}

TEST_CASE("fog and surroundings are read as they are written") {
  const Fog fog = only<Fog>("fog { color=(1,1,1); start=60; end=200; axis=(0,0,-1); density=0.5 }");
  CHECK(fog.start->value == 60);
  CHECK(fog.end->value == 200);
  CHECK(fog.density->value == 0.5);
  CHECK(fog.axis->value[2] == -1);
  const Surroundings cube = only<Surroundings>(
      "cubemap { posx=\"a\"; negx=\"b\"; posy=\"c\"; negy=\"d\"; posz=\"e\"; negz=\"f\"; }");
  CHECK(cube.faces[4]->value == "e");
  CHECK_FALSE(cube.skybox);
  const Surroundings sky = only<Surroundings>(
      "skybox { back=\"b\"; front=\"f\"; left=\"l\"; right=\"r\"; top=\"t\"; bottom=\"o\"; }");
  CHECK(sky.faces[0]->value == "r");
  CHECK(sky.faces[4]->value == "f");
  CHECK(sky.faces[5]->value == "b");
  CHECK(only<Surroundings>("cubemap { file=\"sky/posx.png\"; }").file->value == "sky/posx.png");
  CHECK(messages("cubemap { posx=\"a\"; file=\"b\"; } skybox { top=\"t\"; top=\"u\"; } cubemap {}") ==
        "2:1: error: a cubemap takes 'file' or six faces, not both\n"
        "2:51: error: 'top' is given twice in this skybox\n"
        "2:62: error: cubemap has 0 of its six faces\n");
}

TEST_CASE("the primitives of dialects are read with every spelling of their sizes") {
  const Torus torus = std::get<Torus>(only_primitive("torus { radius=2; ring_radius=0.5; }").shape);
  CHECK(torus.major_radius->value == 2);
  CHECK(torus.minor_radius->value == 0.5);
  CHECK(std::get<Torus>(only_primitive("torus { a=3 b=1 }").shape).major_radius->value == 3);
  CHECK(
      std::get<Torus>(only_primitive("torus { major_radius=3 minor_radius=1 }").shape).minor_radius->value ==
      1);
  const Plane plane = std::get<Plane>(only_primitive("plane { point=(0,1,0); normal=(0,0,1); }").shape);
  CHECK(plane.point->value[1] == 1);
  CHECK(plane.normal->value[2] == 1);
  CHECK_FALSE(std::get<Cylinder>(only_primitive("cylinder { capped=false; }").shape).capped->value);
  const Quadric rows = std::get<Quadric>(only_primitive("quadric { points=((1,2),(3,4,5),(6),); }").shape);
  CHECK(rows.coefficients == std::vector<double>{1, 2, 3, 4, 5, 6});
  const Quadric ten =
      std::get<Quadric>(only_primitive("quadric { coefficients=(1,0,0,1,0,0,1,0,0,-1); }").shape);
  CHECK(ten.coefficients.size() == 10);
  const Quadric bowl =
      std::get<Quadric>(only_primitive("paraboloid { A=1; B=2; lower_bound=3; upper_bound=4; }").shape);
  CHECK(bowl.kind == Quadric::Kind::paraboloid);
  CHECK(bowl.b->value == 2);
  CHECK(bowl.upper_bound->value == 4);
  CHECK(std::get<Quadric>(only_primitive("hyperboloid { type_x = true; }").shape).type_x->value == 1);
  CHECK(std::get<Quadric>(only_primitive("hyperbolic {}").shape).kind == Quadric::Kind::hyperbolic);
  const TorusKnot knot = std::get<TorusKnot>(only_primitive("torus_knot { radius=1 tube=.1 p=2 q=3 }").shape);
  CHECK(knot.q->value == 3);
  const HeightField field = std::get<HeightField>(
      only_primitive("height_field { height_map=\"h\"; color_map=\"c\"; gennormals=true; }").shape);
  CHECK(field.color_map->value == "c");
  CHECK(field.generate_normals);
}

TEST_CASE("maps are read in each spelling, in a material and beside it") {
  const Primitive box = only_primitive(
      "box { material = { diffuse = \"a.bmp\"; bump = bump(\"b.png\"); normal = map(\"n.png\");"
      " ambient = map(\"earth.png\", \"clouds.png\", 0.4); absorb = (1,2,3); specular_model = blinn-phong; }"
      " diffuse_map = \".\\\\x\\\\d.bmp\"; bump_map = \"h.bmp\"; perlin_noise = { scale = 4; "
      "turbulence_depth = 7; } }");
  const auto& set = std::get<MaterialBlock>(box.materials.at(0).value).assignments;
  REQUIRE(set.size() == 6);
  CHECK(std::get<Apart<MapFile>>(set[0].value)->bare);
  CHECK(set[1].parameter == Parameter::bump);
  CHECK_FALSE(std::get<Apart<MapFile>>(set[1].value)->bare);
  CHECK(set[2].parameter == Parameter::normal);
  CHECK(std::get<Apart<MapFile>>(set[3].value)->over == "clouds.png");
  CHECK(std::get<Apart<MapFile>>(set[3].value)->threshold == 0.4);
  CHECK(set[4].parameter == Parameter::absorb);
  CHECK(std::get<std::string>(set[5].value) == "blinn-phong");
  REQUIRE(box.maps.size() == 3);
  CHECK(box.maps[0].parameter == Parameter::diffuse);
  CHECK(std::get<Apart<MapFile>>(box.maps[0].value)->file == ".\\\\x\\\\d.bmp");
  const SolidTexture& noise = *std::get<Apart<SolidTexture>>(box.maps[2].value);
  CHECK(noise.kind == SolidTexture::Kind::perlin_noise);
  CHECK(noise.depth->value == 7);
  CHECK(noise.scale->value[2] == 4);
  const Primitive ball = only_primitive(
      "sphere { material = { diffuse = marble { color = (1,0,0); scale = (1,2,3); depth = 4; lightness = .5 "
      "} } }");
  const SolidTexture& marble = *std::get<Apart<SolidTexture>>(
      std::get<MaterialBlock>(ball.materials.at(0).value).assignments.at(0).value);
  CHECK(marble.kind == SolidTexture::Kind::marble);
  CHECK(marble.scale->value[1] == 2);
  CHECK(messages("material = { specular_model = phnog; }") ==
        "2:31: error: unknown specular model 'phnog': write phong or blinn-phong\n"
        "2:31: note: did you mean 'phong'?\n");
}

TEST_CASE("a height_field needs its height_map") {
  CHECK(messages("height_field { color_map = \"c\"; }") == "2:1: error: height_field has no 'height_map'\n");
}

TEST_CASE("a mesh from a file has no lists of its own") {
  CHECK(scene_of(header + "polymesh { objfile = \"x.obj\"; }").meshes[0].file->value == "x.obj");
  CHECK(messages("polymesh { objfile = \"x.obj\"; points=(); }") ==
        "2:12: error: a mesh takes 'objfile' or lists, not both\n");
  CHECK(messages("trimesh { points=((0,0,0),(1,0,0)); texture_uv=((0,0)); }") ==
        "2:48: error: the mesh has 1 texture coordinate but 2 points: give one for each point or none\n");
}

TEST_CASE("what the language leaves out on purpose is refused by name") {
  CHECK(
      messages("metaball {} translate(1,2,3,csg{}) camera { enable_motion_blur=true; }") ==
      "2:1: error: 'metaball' is an extension of some HKUST projects (implicit surfaces); it is not part of "
      "this "
      "language\n"
      "2:29: error: 'csg' is an extension of some HKUST projects (constructive solid geometry); it is not "
      "part of "
      "this language\n"
      "2:45: error: 'enable_motion_blur' is an extension of an HKUST project (motion blur); it is not part "
      "of "
      "this language\n");
  CHECK(
      messages("particles {} fluid {}") ==
      "2:1: error: 'particles' is an extension of some HKUST projects (particle systems); it is not part of "
      "this "
      "language\n"
      "2:14: error: 'fluid' is an extension of an HKUST project (fluids); it is not part of this language\n");
  CHECK(
      messages("material = { albedo = (1,1,1); } portal {}") ==
      "2:14: error: 'albedo' is an extension of some projects that trace paths (materials and emitters); it "
      "is "
      "not part of this language\n"
      "2:34: error: 'portal' belongs to the JSON scenes of newer UT Austin projects; it is not part of this "
      "language\n");
}

TEST_CASE("permissive reading passes over what is unknown, with a warning each, and keeps the rest") {
  const std::string body =
      "camera { fov = 30; zoom = 3; }\n"
      "metaball { ball = (1,2,3,4); material = { diffuse = (1,0,0); } size = 1; }\n"
      "sphere { radius = 2; material = { shine = 3; diffuse = (1,0,0); } }\n"
      "translate(1,2,3, csg { a = sphere {}; })\n"
      "{ blob { } box { } }\n";
  CHECK(permissive_messages(body) ==
        "warning: unknown attribute 'zoom' in the camera: passed over\n"
        "warning: 'metaball' is an extension of some HKUST projects (implicit surfaces); it is not part of "
        "this "
        "language, and passed over\n"
        "warning: unknown attribute 'radius' in a sphere: passed over\n"
        "warning: unknown attribute 'shine' in a material: passed over\n"
        "warning: 'csg' is an extension of some HKUST projects (constructive solid geometry); it is not part "
        "of "
        "this language, and passed over\n"
        "warning: unknown word 'blob': passed over\n");
  const Source source = Source::from_text("scene.ray", header + body);
  Diagnostics diagnostics;
  ParseOptions options;
  options.permissive = true;
  const Scene scene = parse(source, diagnostics, options);
  REQUIRE(scene.items.size() == 3);
  CHECK(std::get<Camera>(scene.items[0]).fov->value == 30);
  const auto& sphere = std::get<Primitive>(scene.elements[std::get<ElementId>(scene.items[1])].what);
  CHECK(std::get<MaterialBlock>(sphere.materials.at(0).value).assignments.size() == 1);
  const Element& group = scene.elements[std::get<ElementId>(scene.items[2])];
  CHECK(std::holds_alternative<Box>(std::get<Primitive>(scene.elements[group.first_child].what).shape));
  CHECK(permissive_messages("sphere { radius = (1 }") != "");
  CHECK(permissive_messages("camera { fov = wide; }") == "error: 'fov' takes a number, found 'wide'\n");
}
