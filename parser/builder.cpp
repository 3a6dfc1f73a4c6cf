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
  primitive_.shape = shape;
  primitive_keyword_ = keyword;
  errors_before_ = diagnostics_.error_count();
}

ElementId Builder::end_primitive(Span span) {
  if (const auto* id = std::get_if<MeshId>(&primitive_.shape)) {
    if (!errors_since_begin())
      check_mesh(source_, scene_.meshes[id->index], primitive_keyword_, diagnostics_);
  }
  const ElementId element = open(std::move(primitive_), primitive_keyword_);
  scene_.elements[element].span = span;
  return element;
}

// --- meshes ------------------------------------------------------------------------------------------------

void Builder::begin_mesh(Span keyword) {
  begin_primitive(MeshId{static_cast<std::uint32_t>(scene_.meshes.size())}, keyword);
  scene_.meshes.emplace_back();
}

ListStop Builder::read_list(Kind attribute, Span open) {
  Mesh& mesh = scene_.meshes.back();
  const bool faces = attribute == T::FACES;
  std::vector<double>& numbers = attribute == T::NORMALS ? mesh.normals : mesh.points;
  const std::uint64_t first = faces ? mesh.corners.size() : numbers.size();
  const ListStop stop = faces ? read_faces(source_, open.end, mesh.corners, mesh.face_sizes, diagnostics_)
                              : read_triples(source_, open.end, numbers, diagnostics_);
  const std::uint64_t count = (faces ? mesh.corners.size() : numbers.size()) - first;
  auto& lists = faces ? mesh.face_lists : attribute == T::NORMALS ? mesh.normal_lists : mesh.point_lists;
  lists.push_back({first, count, {open.begin, stop.offset}});
  return stop;
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
