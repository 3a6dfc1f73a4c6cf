#include "parser/plain_materials.hpp"

#include <catch2/catch.hpp>

#include "parser/parse.hpp"

using namespace trace::parser;

namespace {

Mesh mesh_with(const std::string& materials) {
  const Source source =
      Source::from_text("m.ray", "SBT-raytracer 1.0 trimesh{materials=(" + materials + ");}");
  Diagnostics diagnostics;
  Scene scene = parse(source, diagnostics);
  return scene.meshes.at(0);
}

std::array<double, 3> diffuse(const Mesh& mesh, std::size_t entry) {
  const Material& material = mesh.vertex_materials.materials.at(mesh.vertex_materials.index(entry));
  return std::get<std::array<double, 3>>(std::get<MaterialBlock>(material.value).assignments.at(0).value);
}

}  // namespace

TEST_CASE("Plain materials stop in front of the first entry that is anything else") {
  const auto stop = [](const std::string& text) {
    VertexMaterials materials;
    const std::uint32_t end = read_plain_materials(Source::from_text("", text), 0, materials);
    return std::pair(end, materials.count());
  };
  CHECK(stop("{index=1},{name a;},") == std::pair(10u, std::size_t{1}));
  CHECK(stop("{index=1},{diffuse=map(\"a.png\")},") == std::pair(10u, std::size_t{1}));
  CHECK(stop("{diffuse=(1,2)},") == std::pair(0u, std::size_t{0}));
  CHECK(stop("{index=1e999},") == std::pair(0u, std::size_t{0}));
  CHECK(stop("{index=1}") == std::pair(0u, std::size_t{0}));  // the last entry is the grammar's
  CHECK(stop("{ /* } */ index = 1 ; shininess=-2.5e-1} , // c\n{},x") == std::pair(51u, std::size_t{2}));
  CHECK(stop("{index=1") == std::pair(0u, std::size_t{0}));
}

TEST_CASE("Vertex materials keep their order, whoever reads them, and those written alike are held once") {
  const Mesh mesh = mesh_with(
      "{diffuse=(1,0,0)},{diffuse=(2,0,0)},{diffuse=(1,0,0)},{diffuse=(3,0,0);name a;},{diffuse=(2,0,0)},"
      "{diffuse=(1,0,0)}");
  REQUIRE(mesh.vertex_materials.count() == 6);
  const double expected[] = {1, 2, 1, 3, 2, 1};
  for (std::size_t i = 0; i < 6; ++i) CHECK(diffuse(mesh, i)[0] == expected[i]);
  CHECK(mesh.vertex_materials.index(0) == mesh.vertex_materials.index(2));
}
