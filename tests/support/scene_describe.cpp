#include "tests/support/scene_describe.hpp"

#include <fstream>

#include "scene/build.hpp"

namespace trace::test {

parser::MaterialAssignment is(Parameter parameter, double number) {
  return {parameter, number, {}, {}};
}

parser::MaterialAssignment is(Parameter parameter, double r, double g, double b) {
  return {parameter, std::array<double, 3>{r, g, b}, {}, {}};
}

parser::MaterialAssignment is_map(Parameter parameter, const std::string& file) {
  return {parameter, parser::MapFile{file}, {10, 30}, {20, 30}};
}

parser::Material block(std::vector<parser::MaterialAssignment> assignments) {
  return {parser::MaterialBlock{std::move(assignments), {}}, {}};
}

parser::Material block_named(const std::string& name, std::vector<parser::MaterialAssignment> assignments) {
  return {parser::MaterialBlock{std::move(assignments), parser::Name{name, {}}}, {}};
}

parser::Material named(const std::string& name) {
  return {parser::Name{name, {}}, {}};
}

parser::Primitive primitive(PrimitiveShape shape, std::vector<parser::Material> materials) {
  return {shape, std::move(materials), {}};
}

parser::ElementId Describe::element(decltype(parser::Element::what) what,
                                    std::vector<parser::ElementId> children) {
  for (std::size_t i = 0; i + 1 < children.size(); ++i) {
    scene.elements[children[i]].next_sibling = children[i + 1];
  }
  parser::Element made;
  made.what = std::move(what);
  if (!children.empty()) made.first_child = children.front();
  scene.elements.push_back(std::move(made));
  return static_cast<parser::ElementId>(scene.elements.size() - 1);
}

parser::ElementId Describe::mesh(parser::Mesh mesh, std::vector<parser::Material> materials,
                                 std::size_t materials_before_list) {
  for (parser::MaterialList& list : mesh.material_lists) list.materials_before = materials_before_list;
  scene.meshes.push_back(std::move(mesh));
  const parser::MeshId id{static_cast<std::uint32_t>(scene.meshes.size() - 1)};
  return element(parser::Primitive{id, std::move(materials), {}});
}

parser::Mesh triangle_mesh(std::vector<parser::Material> materials) {
  parser::Mesh mesh;
  mesh.points = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
  mesh.corners = {0, 1, 2};
  if (!materials.empty()) mesh.material_lists = {{{0, materials.size(), {}}, 0}};
  mesh.vertex_materials.materials = std::move(materials);
  return mesh;
}

Built build(const Describe& description, const std::string& folder) {
  // Only a file has a folder that its textures are looked for in.
  if (folder != ".") std::ofstream(folder + "/scene.ray") << std::string(64, ' ');
  const parser::Source source = folder == "." ? parser::Source::from_text("scene.ray", std::string(64, ' '))
                                              : parser::Source::from_file(folder + "/scene.ray");
  Built built;
  FileImages images;
  built.scene = build_scene(description.scene, source, images, built.diagnostics);
  return built;
}

}  // namespace trace::test
