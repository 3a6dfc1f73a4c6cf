// Descriptions of scenes made by hand, as the parser would have made them.
#pragma once

#include <initializer_list>
#include <vector>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/scene.hpp"

namespace trace::test {

using parser::Parameter;

parser::MaterialAssignment is(Parameter parameter, double number);
parser::MaterialAssignment is(Parameter parameter, double r, double g, double b);
parser::MaterialAssignment is_map(Parameter parameter, const std::string& file);

parser::Material block(std::vector<parser::MaterialAssignment> assignments);
parser::Material block_named(const std::string& name, std::vector<parser::MaterialAssignment> assignments);
parser::Material named(const std::string& name);

using PrimitiveShape = decltype(parser::Primitive::shape);
parser::Primitive primitive(PrimitiveShape shape, std::vector<parser::Material> materials = {});

// Elements are made from the inside out and put at the top level last.
class Describe {
 public:
  parser::Scene scene;

  parser::ElementId element(decltype(parser::Element::what) what,
                            std::vector<parser::ElementId> children = {});
  parser::ElementId mesh(parser::Mesh mesh, std::vector<parser::Material> materials = {},
                         std::size_t materials_before_list = 0);

  void top(parser::Item item) { scene.items.push_back(std::move(item)); }
  void top(parser::Primitive p) { top(parser::Item(element(std::move(p)))); }
};

// One triangle with a material a point where `materials` has three.
parser::Mesh triangle_mesh(std::vector<parser::Material> materials = {});

// The runtime scene, and what was said about the description. Textures are looked for in `folder`.
struct Built {
  Scene scene;
  parser::Diagnostics diagnostics;

  // The values of the material of an object, in file order.
  const Material& material(std::size_t object) const {
    return scene.materials[scene.objects[object].material].values;
  }
  // Where the origin of an object's space is in the world.
  Vec3 place(std::size_t object, const Vec3& local = Vec3(0)) const {
    return Vec3(scene.frames[scene.objects[object].frame].to_world * Vec4(local, 1));
  }
};
Built build(const Describe& description, const std::string& folder = ".");

}  // namespace trace::test
