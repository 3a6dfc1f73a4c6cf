// What is written is what is described.
#include <catch2/catch.hpp>

#include "helpers.hpp"

using namespace trace::parser;
using namespace trace::parser::test;

namespace {

using Triple = std::array<double, 3>;

template <class Type>
const Type& item(const Scene& scene, std::size_t index) {
  return std::get<Type>(scene.items.at(index));
}

const Element& root(const Scene& scene, std::size_t index) {
  return scene.elements.at(item<ElementId>(scene, index));
}

const MaterialBlock& block(const Material& material) {
  return std::get<MaterialBlock>(material.value);
}

}  // namespace

TEST_CASE("versions up to 1.1 are read, older and negative ones too") {
  CHECK(scene_of("SBT-raytracer 1.1").version == 1.1);
  CHECK(scene_of(" // first\n SBT-raytracer -5\n").version == -5);
}

TEST_CASE("a camera keeps what it gives and nothing else") {
  const Scene scene =
      scene_of(header + "camera{position=(1,2,3) fov=45;aspectratio=1.5;quaternian=(1,2,3,4)}camera{}");
  const Camera& camera = item<Camera>(scene, 0);
  CHECK(camera.position->value == Triple{1, 2, 3});
  CHECK(camera.fov->value == 45);
  CHECK(camera.aspectratio->value == 1.5);
  CHECK(camera.quaternion->value == std::array<double, 4>{1, 2, 3, 4});
  CHECK_FALSE(camera.viewdir);
  CHECK(camera.span.begin == header.size());
  CHECK(item<Camera>(scene, 1).span.begin == camera.span.end);
  CHECK(camera.fov->span == Span{46, 48});
  CHECK_FALSE(item<Camera>(scene, 1).position);
}

TEST_CASE("the last of an attribute given twice in a camera counts") {
  const Scene scene = scene_of(header + "camera{fov=1;fov=2;viewdir=(0,0,1);updir=(0,1,0)}");
  CHECK(item<Camera>(scene, 0).fov->value == 2);
  CHECK(item<Camera>(scene, 0).updir->value == Triple{0, 1, 0});
}

TEST_CASE("lights keep their attributes in any order") {
  const Scene scene = scene_of(header +
                               "ambient_light{color=(.1,.2,.3)}"
                               "directional_light{colour=(1,1,1)direction=(0,-1,0);}"
                               "point_light{linear_attenuation_coeff=2;color=(1,1,1);position=(4,5,6)}");
  CHECK(item<AmbientLight>(scene, 0).color.value == Triple{.1, .2, .3});
  CHECK(item<DirectionalLight>(scene, 1).direction.value == Triple{0, -1, 0});
  const auto& point = item<PointLight>(scene, 2);
  CHECK(point.position.value == Triple{4, 5, 6});
  CHECK(point.linear->value == 2);
  CHECK_FALSE(point.constant);
  CHECK_FALSE(point.quadratic);
}

TEST_CASE("a material keeps its assignments in file order, with their places") {
  const std::string text =
      header + "material={shininess=2;diffuse=map(\"a b.png\")diffuse=(1,0,0);index=map(\"i\");}";
  const Scene scene = scene_of(text);
  const MaterialBlock& material = block(item<Material>(scene, 0));
  REQUIRE(material.assignments.size() == 4);
  CHECK(std::get<double>(material.assignments[0].value) == 2);
  CHECK(std::get<Apart<MapFile>>(material.assignments[1].value)->file == "a b.png");
  CHECK(material.assignments[1].parameter == Parameter::diffuse);
  CHECK(std::get<Triple>(material.assignments[2].value) == Triple{1, 0, 0});
  CHECK(material.assignments[3].parameter == Parameter::index);
  const auto written = [&](Span span) { return text.substr(span.begin, span.end - span.begin); };
  CHECK(written(material.assignments[2].span) == "diffuse=(1,0,0)");
  CHECK(written(material.assignments[2].value_span) == "(1,0,0)");
}

TEST_CASE("materials are named without '=' and referred to with and without quotes") {
  const Scene scene =
      scene_of(header + "material={name \"red\";}sphere{material=red}sphere{material=\"red\";}");
  CHECK(block(item<Material>(scene, 0)).name->value == "red");
  for (std::size_t i = 1; i < 3; ++i) {
    const auto& primitive = std::get<Primitive>(root(scene, i).what);
    CHECK(std::get<Name>(primitive.materials.at(0).value).value == "red");
  }
}

TEST_CASE("a primitive keeps all its materials in order, and its name") {
  const Scene scene = scene_of(header + "cylinder{material={};name=x-1;material={index=2}}");
  const auto& primitive = std::get<Primitive>(root(scene, 0).what);
  CHECK(std::holds_alternative<Cylinder>(primitive.shape));
  CHECK(primitive.materials.size() == 2);
  CHECK(primitive.name->value == "x-1");
  CHECK(root(scene, 0).keyword == Span{18, 26});
}

TEST_CASE("a cone keeps the attributes that are given") {
  const Scene scene = scene_of(header + "cone{capped=false;height=2 bottom_radius=-1}");
  const auto& cone = std::get<Cone>(std::get<Primitive>(root(scene, 0).what).shape);
  CHECK_FALSE(cone.capped->value);
  CHECK(cone.height->value == 2);
  CHECK(cone.bottom_radius->value == -1);
  CHECK_FALSE(cone.top_radius);
}

TEST_CASE("a mesh knows which material its vertex materials inherit from") {
  const Scene scene = scene_of(header +
                               "trimesh{material={index=1}materials=({index=2},{});material={index=3};"
                               "materials=({name \"a\";});normals=((0,0,1),(0,0,1),(0,0,1));gennormals;"
                               "points=((0,0,0),(1,0,0),(0,1,0));}");
  const auto& primitive = std::get<Primitive>(root(scene, 0).what);
  const Mesh& mesh = scene.meshes.at(std::get<MeshId>(primitive.shape).index);
  CHECK(primitive.materials.size() == 2);
  REQUIRE(mesh.material_lists.size() == 2);
  CHECK(mesh.material_lists[0].materials_before == 1);
  CHECK(mesh.material_lists[1].materials_before == 2);
  CHECK(mesh.material_lists[1].list.first == 2);
  CHECK(mesh.vertex_materials.count() == 3);
  CHECK(mesh.normals.size() == 9);
  CHECK(mesh.generate_normals);
}

TEST_CASE("transforms keep their numbers and their one child") {
  const Scene scene =
      scene_of(header +
               "translate(1,2,3,sphere{})rotate(0,0,1,.5,box{});scale(2,box{})scale(1,2,3,box{})"
               "transform((1,2,3,4),(5,6,7,8),(9,10,11,12),(13,14,15,16),square{})");
  CHECK(std::get<Translate>(root(scene, 0).what).offset == Triple{1, 2, 3});
  const auto& rotate = std::get<Rotate>(root(scene, 1).what);
  CHECK(rotate.axis == Triple{0, 0, 1});
  CHECK(rotate.angle == .5);
  CHECK(std::get<Scale>(root(scene, 2).what).factors == Triple{2, 2, 2});
  CHECK(std::get<Scale>(root(scene, 3).what).factors == Triple{1, 2, 3});
  CHECK(std::get<Transform>(root(scene, 4).what).rows[1] == std::array<double, 4>{5, 6, 7, 8});
  const Element& child = scene.elements.at(root(scene, 4).first_child);
  CHECK(std::holds_alternative<Square>(std::get<Primitive>(child.what).shape));
  CHECK(child.next_sibling == no_element);
}

TEST_CASE("a group keeps its elements and materials in order") {
  const Scene scene = scene_of(header + "{sphere{};material={index=2};box{}{}}");
  CHECK(std::holds_alternative<Group>(root(scene, 0).what));
  std::vector<std::size_t> kinds;
  for (ElementId id = root(scene, 0).first_child; id != no_element; id = scene.elements.at(id).next_sibling) {
    kinds.push_back(scene.elements[id].what.index());
  }
  CHECK(kinds == std::vector<std::size_t>{0, 6, 0, 1});
  CHECK(root(scene, 0).span == Span{18, 55});
}

TEST_CASE("stray semicolons stand for nothing") {
  const Scene scene =
      scene_of(header +
               ";;camera{;fov=1;;};sphere{;;material={;;diffuse=(1,1,1);;};;};;{;sphere{};;material={};;};"
               "translate(0,0,0,sphere{};;);ambient_light{;color=(1,1,1);;};trimesh{;points=();;};");
  CHECK(scene.items.size() == 6);
}

TEST_CASE("items stand in file order") {
  const Scene scene = scene_of(header + "sphere{}material={}camera{}box{}");
  REQUIRE(scene.items.size() == 4);
  CHECK(std::holds_alternative<ElementId>(scene.items[0]));
  CHECK(std::holds_alternative<Material>(scene.items[1]));
  CHECK(std::holds_alternative<Camera>(scene.items[2]));
  CHECK(std::holds_alternative<ElementId>(scene.items[3]));
}

TEST_CASE("empty meshes and degenerate faces are legal") {
  const Scene scene =
      scene_of(header + "trimesh{}trimesh{points=();faces=();}trimesh{points=((0,0,0));faces=((0,0,0));}");
  CHECK(scene.meshes.size() == 3);
}

TEST_CASE("line ends of every kind and a missing last one are the same") {
  const std::string end = GENERATE("\n", "\r\n", "\r");
  const Scene scene = scene_of("SBT-raytracer 1.0" + end + "// comment" + end + "sphere{" + end + "}// last");
  CHECK(scene.items.size() == 1);
}
