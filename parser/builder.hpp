// What the grammar has read becomes the Scene, piece by piece; what is wrong beyond syntax is reported here.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "parser/list_reader.hpp"
#include "parser/token.hpp"

namespace trace::parser {

enum class LightVector : std::uint8_t { position, direction, color };
enum class Attenuation : std::uint8_t { constant, linear, quadratic };

class Builder {
 public:
  Builder(const Source& source, Diagnostics& diagnostics, Dialect dialect, bool permissive)
      : source_(source), diagnostics_(diagnostics) {
    scene_.dialect = dialect;
    scene_.permissive = permissive;
  }

  Scene take() { return std::move(scene_); }

  // False if this program cannot read the version.
  bool version(double number, Span span);

  template <class What>
  void add_item(What what) {
    scene_.items.emplace_back(std::move(what));
  }

  // Cameras. The block that is being read is kept here, as lights and primitives are: none of them nest.
  void begin_camera();
  Camera& camera() { return camera_; }
  void viewdir(Vector3 value, Span word);
  void updir(Vector3 value, Span word);
  void look_at(Vector3 value, Span word);
  void aspectratio(Scalar value);
  void projection(const Name& name);
  void camera_height(Scalar value);
  void end_camera(Span span);

  // Lights: each attribute once.
  void begin_light(std::string_view word, Span keyword);
  void light_vector(LightVector which, Vector3 value, Span word);
  void attenuation(Attenuation which, Scalar value, Span word);
  void end_ambient_light(Span span);
  void end_directional_light(Span span);
  void end_point_light(Span span);

  void begin_dialect_light(DialectLight::Kind kind, Span keyword);
  void light_attribute(std::string_view word, std::variant<double, std::array<double, 3>> value,
                       Span word_span, Span value_span);
  void end_dialect_light(Span span);

  // Surroundings.
  void begin_fog(Span keyword);
  Fog& fog() { return fog_; }
  void end_fog(Span span);
  void begin_surroundings(bool skybox, Span keyword);
  Surroundings& surroundings() { return surroundings_; }
  void face(std::string_view word, Name file, Span word_span);
  void end_surroundings(Span span);

  // An attribute that some projects write and none reads.
  void without_effect(std::string_view word, Span span, std::string_view block);

  // Materials.
  MaterialBlock assign(MaterialBlock block, Parameter parameter, MaterialAssignment value, Span span);
  MaterialBlock name_block(MaterialBlock block, Name name);
  Material block(MaterialBlock block, Span span);
  Material reference(Name name);
  MaterialBlock specular_model(MaterialBlock block, const Name& name, Span span);
  static MapFile map(std::string_view file);
  static MapFile map(std::string_view file, std::string_view over, double threshold);
  static MapFile bare_map(std::string_view file);
  static Vector3 uniform_vector(double number, Span span) { return {{number, number, number}, span}; }
  static Scalar as_number(const Located<bool>& value) { return {value.value ? 1.0 : 0.0, value.span}; }

  // Elements.
  ElementId open(decltype(Element::what) what, Span keyword);
  ElementId close(ElementId parent, Chain children, Span span);
  ElementId close(ElementId parent, ElementId child, Span span) {
    return close(parent, {child, child}, span);
  }
  Chain append(Chain chain, ElementId element);
  ElementId material_element(Material material);
  static Scale uniform_scale(double factor) { return {{factor, factor, factor}}; }

  void begin_primitive(decltype(Primitive::shape) shape, Span keyword);
  Primitive& primitive() { return primitive_; }
  template <class Shape>
  Shape& shape() {
    return std::get<Shape>(primitive_.shape);
  }
  void begin_quadric(Quadric::Kind kind, Span keyword);
  void coefficients(std::vector<double> numbers, Span span);
  void coefficients_in_rows(Span span);  // those that read_list has read
  void map_beside(Parameter parameter, MaterialAssignment value, Span span);
  void noise_beside(SolidTexture noise, Span span, Span value_span);
  ElementId end_primitive(Span span);

  // Meshes. read_list reads the list of `attribute` (POINTS, NORMALS, FACES or TEXTURE_UV) behind the '(' at
  // `open`; points are also the coefficients of a quadric.
  void begin_mesh(Span keyword);
  Mesh& mesh() { return scene_.meshes.back(); }
  ListStop read_list(Kind attribute, Span open);
  // The plain entries from the '{' at `open` on (plain_materials.hpp); take_plain_materials gives them to the
  // grammar.
  std::uint32_t read_plain_materials(Span open);
  VertexMaterials take_plain_materials() { return std::exchange(plain_materials_, {}); }
  void vertex_materials(VertexMaterials materials, Span span);
  void mesh_file(Name file, Span word);

 private:
  // A light's attribute and the word it was given by.
  struct Given {
    std::optional<Vector3> value;
    Span word;
  };
  struct LightParts {
    std::string_view word;
    Span keyword;
    std::array<Given, 3> vectors;
    std::array<std::optional<Scalar>, 3> attenuation;
    std::array<Span, 3> attenuation_words;
  };

  bool errors_since_begin() const { return diagnostics_.error_count() != errors_before_; }
  void given_twice(std::string_view attribute, Span first, Span again);
  bool require(LightVector which);
  const Vector3& given(LightVector which) const {
    return *light_.vectors[static_cast<std::size_t>(which)].value;
  }

  const Source& source_;
  Diagnostics& diagnostics_;
  Scene scene_;
  Camera camera_;
  Span viewdir_word_, updir_word_, look_at_word_;
  LightParts light_;
  DialectLight dialect_light_;
  Fog fog_;
  Surroundings surroundings_;
  Primitive primitive_;
  VertexMaterials plain_materials_;
  Span mesh_file_word_;
  Span primitive_keyword_;
  std::size_t errors_before_ = 0;  // when the block that is being read began
  std::size_t unknown_names_ = 0;  // errors about names of materials
  std::map<std::string, Span, std::less<>> named_materials_;
};

}  // namespace trace::parser
