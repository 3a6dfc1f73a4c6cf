#include "parser/builder.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "parser/mesh_checks.hpp"
#include "parser/plain_materials.hpp"
#include "parser/printable.hpp"

namespace trace::parser {

bool Builder::version(double number, Span span) {
  constexpr double newest = 1.1;
  scene_.version = number;
  if (number <= newest) return true;
  const std::string_view written = source_.text().substr(span.begin, span.end - span.begin);
  diagnostics_.error(span,
                     fmt::format("version {} is newer than 1.1, the newest this program reads", written));
  return false;
}

// --- materials ---------------------------------------------------------------------------------------------

MaterialBlock Builder::assign(MaterialBlock block, Parameter parameter, MaterialAssignment value, Span span) {
  value.parameter = parameter;
  value.span = span;
  block.assignments.push_back(std::move(value));
  return block;
}

MaterialBlock Builder::name_block(MaterialBlock block, Name name) {
  block.name = std::move(name);
  return block;
}

Material Builder::block(MaterialBlock block, Span span) {
  if (block.name) {
    const auto [place, added] = named_materials_.try_emplace(block.name->value, block.name->span);
    if (!added) {
      diagnostics_
          .error(block.name->span, fmt::format("the material {} is already defined", in_quotes(place->first)))
          .notes.push_back({place->second, "first defined here"});
    }
  }
  return {std::move(block), span};
}

Material Builder::reference(Name name) {
  const Span span = name.span;
  // After other errors the material may be among what was passed over.
  const bool sure = diagnostics_.error_count() == unknown_names_;
  if (sure && named_materials_.find(name.value) == named_materials_.end()) {
    ++unknown_names_;
    constexpr std::size_t most_suggested = 1000;
    std::vector<std::string_view> known;
    if (named_materials_.size() <= most_suggested) {
      for (const auto& entry : named_materials_) known.push_back(entry.first);
    }
    diagnostics_.error(span, fmt::format("there is no material named {} before this", in_quotes(name.value)))
        .suggestion = closest(name.value, known);
  }
  return {std::move(name), span};
}

MaterialBlock Builder::specular_model(MaterialBlock block, const Name& name, Span span) {
  if (name.value != "phong" && name.value != "blinn-phong") {
    diagnostics_
        .error(name.span,
               fmt::format("unknown specular model {}: write phong or blinn-phong", in_quotes(name.value)))
        .suggestion = closest(name.value, {"phong", "blinn-phong"});
  }
  return assign(std::move(block), Parameter::specular_model, {{}, name.value, {}, name.span}, span);
}

MapFile Builder::map(std::string_view file) {
  return {std::string(file), false, {}, 0};
}
MapFile Builder::map(std::string_view file, std::string_view over, double threshold) {
  return {std::string(file), false, std::string(over), threshold};
}
MapFile Builder::bare_map(std::string_view file) {
  return {std::string(file), true, {}, 0};
}

// --- elements ----------------------------------------------------------------------------------------------

ElementId Builder::open(decltype(Element::what) what, Span keyword) {
  Element& element = scene_.elements.emplace_back();
  element.what = std::move(what);
  element.keyword = keyword;
  element.span = keyword;
  return static_cast<ElementId>(scene_.elements.size() - 1);
}

ElementId Builder::close(ElementId parent, Chain children, Span span) {
  scene_.elements[parent].first_child = children.first;
  scene_.elements[parent].span = span;
  return parent;
}

Chain Builder::append(Chain chain, ElementId element) {
  if (chain.first == no_element) return {element, element};
  scene_.elements[chain.last].next_sibling = element;
  return {chain.first, element};
}

ElementId Builder::material_element(Material material) {
  const Span span = material.span;
  return open(std::move(material), span);
}

void Builder::begin_primitive(decltype(Primitive::shape) shape, Span keyword) {
  primitive_ = {};
  primitive_.shape = std::move(shape);
  primitive_keyword_ = keyword;
  errors_before_ = diagnostics_.error_count();
}

ElementId Builder::end_primitive(Span span) {
  if (const auto* id = std::get_if<MeshId>(&primitive_.shape)) {
    const Mesh& mesh = scene_.meshes[id->index];
    if (!errors_since_begin() && mesh.file && !mesh.has_no_lists()) {
      diagnostics_.error(mesh_file_word_, "a mesh takes 'objfile' or lists, not both");
    } else if (!errors_since_begin()) {
      check_mesh(source_, mesh, primitive_keyword_, diagnostics_);
    }
  }
  const auto* field = std::get_if<HeightField>(&primitive_.shape);
  if (field && !field->height_map && !errors_since_begin()) {
    diagnostics_.error(primitive_keyword_, "height_field has no 'height_map'");
  }
  const ElementId element = open(std::move(primitive_), primitive_keyword_);
  scene_.elements[element].span = span;
  return element;
}

void Builder::begin_quadric(Quadric::Kind kind, Span keyword) {
  Quadric quadric;
  quadric.kind = kind;
  begin_primitive(std::move(quadric), keyword);
}

void Builder::coefficients(std::vector<double> numbers, Span span) {
  shape<Quadric>().coefficients = std::move(numbers);
  shape<Quadric>().coefficients_span = span;
}

void Builder::coefficients_in_rows(Span span) {
  shape<Quadric>().coefficients_span = span;
}

void Builder::map_beside(Parameter parameter, MaterialAssignment value, Span span) {
  value.parameter = parameter;
  value.span = span;
  primitive_.maps.push_back(std::move(value));
}

void Builder::noise_beside(SolidTexture noise, Span span, Span value_span) {
  primitive_.maps.push_back({Parameter::diffuse, std::move(noise), span, value_span});
}

// --- meshes ------------------------------------------------------------------------------------------------

void Builder::begin_mesh(Span keyword) {
  begin_primitive(MeshId{static_cast<std::uint32_t>(scene_.meshes.size())}, keyword);
  scene_.meshes.emplace_back();
}

ListStop Builder::read_list(Kind attribute, Span open) {
  if (auto* quadric = std::get_if<Quadric>(&primitive_.shape)) {
    return read_tuples(0, source_, open.end, quadric->coefficients, diagnostics_);
  }
  Mesh& mesh = scene_.meshes.back();
  const auto read = [&](auto& values, std::vector<ListSpan>& lists, const auto& reader) {
    const std::uint64_t first = values.size();
    const ListStop stop = reader();
    lists.push_back({first, values.size() - first, {open.begin, stop.offset}});
    return stop;
  };
  const auto tuples = [&](std::size_t numbers, std::vector<double>& values, std::vector<ListSpan>& lists) {
    return read(values, lists, [&] { return read_tuples(numbers, source_, open.end, values, diagnostics_); });
  };
  switch (attribute) {
    case T::FACES:
      return read(mesh.corners, mesh.face_lists,
                  [&] { return read_faces(source_, open.end, mesh.corners, mesh.face_sizes, diagnostics_); });
    case T::NORMALS:
      return tuples(3, mesh.normals, mesh.normal_lists);
    case T::TEXTURE_UV:
      return tuples(2, mesh.texture_coordinates, mesh.coordinate_lists);
    default:
      return tuples(3, mesh.points, mesh.point_lists);
  }
}

std::uint32_t Builder::read_plain_materials(Span open) {
  VertexMaterials plain;
  const std::uint32_t end = parser::read_plain_materials(source_, open.begin, plain);
  if (end != open.begin) plain_materials_ = std::move(plain);
  return end;
}

void Builder::vertex_materials(VertexMaterials materials, Span span) {
  VertexMaterials& all = mesh().vertex_materials;
  mesh().material_lists.push_back({{all.count(), materials.count(), span}, primitive_.materials.size()});
  all.append(std::move(materials));
}

void Builder::mesh_file(Name file, Span word) {
  mesh().file = std::move(file);
  mesh_file_word_ = word;
}

void VertexMaterials::append(VertexMaterials more) {
  if (of.empty()) {
    *this = std::move(more);
    return;
  }
  const auto first = static_cast<std::uint32_t>(materials.size());
  for (const std::uint32_t index : more.of) of.push_back(first + index);
  materials.insert(materials.end(), std::make_move_iterator(more.materials.begin()),
                   std::make_move_iterator(more.materials.end()));
}

}  // namespace trace::parser
