#include "scene/material_resolver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include "scene/solid_pattern_of.hpp"

namespace trace {
namespace {

using parser::Parameter;

struct ColorSlot {
  Rgb* value;
  TextureId* map;  // nullptr where a map has no effect
  const char* name;
};

ColorSlot color_slot(MappedMaterial& m, Parameter parameter) {
  switch (parameter) {
    case Parameter::emissive:
      return {&m.values.emissive, &m.emissive, "emissive"};
    case Parameter::ambient:
      return {&m.values.ambient, &m.ambient, "ambient"};
    case Parameter::diffuse:
      return {&m.values.diffuse, &m.diffuse, "diffuse"};
    case Parameter::specular:
      return {&m.values.specular, &m.specular, "specular"};
    case Parameter::reflective:
      return {&m.values.reflective, nullptr, "reflective"};
    case Parameter::transmissive:
      return {&m.values.transmissive, nullptr, "transmissive"};
    case Parameter::index:
      return {&m.values.index, &m.index, "index"};
    default:
      break;
  }
  return {&m.values.shininess, &m.shininess, "shininess"};
}

bool assigns(const parser::MaterialBlock& block, Parameter parameter) {
  return std::any_of(block.assignments.begin(), block.assignments.end(),
                     [&](const parser::MaterialAssignment& a) { return a.parameter == parameter; });
}

}  // namespace

MappedMaterial MaterialResolver::resolve(const parser::Material& material, const MappedMaterial& inherited) {
  if (const auto* name = std::get_if<parser::Name>(&material.value)) {
    const auto found = named_.find(name->value);
    return found == named_.end() ? inherited : found->second;  // the parser has refused unknown names
  }
  const auto& block = std::get<parser::MaterialBlock>(material.value);
  MappedMaterial result = inherited;
  for (const parser::MaterialAssignment& assignment : block.assignments) assign(result, assignment);
  if (rules_.specular_reflects && assigns(block, Parameter::specular) &&
      !assigns(block, Parameter::reflective)) {
    result.values.reflective = result.specular == no_texture ? result.values.specular : Rgb(0);
  }
  if (block.name) named_[block.name->value] = result;
  return result;
}

// Parameters that have no map.
bool MaterialResolver::assign_extra(MappedMaterial& result, const parser::MaterialAssignment& assignment) {
  switch (assignment.parameter) {
    case Parameter::specular_model:
      if (const auto* word = std::get_if<std::string>(&assignment.value)) {
        result.blinn_phong = *word == "blinn-phong";
        if (!result.blinn_phong && *word != "phong") {
          diagnostics_.error(assignment.value_span, "'specular_model' is \"phong\" or \"blinn-phong\"");
        }
      }
      return true;
    case Parameter::absorb:
      if (const auto* c = std::get_if<std::array<double, 3>>(&assignment.value)) {
        result.absorb = Rgb((*c)[0], (*c)[1], (*c)[2]);
        if (!glm::all(glm::greaterThanEqual(result.absorb, Rgb(0)))) {
          diagnostics_.error(assignment.value_span, "'absorb' must not be negative");
        }
      } else {
        diagnostics_.error(assignment.value_span, "'absorb' takes three numbers");
      }
      return true;
    case Parameter::glossiness:
      if (const auto* number = std::get_if<double>(&assignment.value)) {
        result.glossiness = *number;
        if (!(*number >= 0)) diagnostics_.error(assignment.value_span, "'glossiness' must not be negative");
      } else {
        diagnostics_.error(assignment.value_span, "'glossiness' takes one number");
      }
      return true;
    default:
      return false;
  }
}

MappedMaterial MaterialResolver::with(const MappedMaterial& material,
                                      const std::vector<parser::MaterialAssignment>& assignments) {
  MappedMaterial result = material;
  for (const parser::MaterialAssignment& assignment : assignments) assign(result, assignment);
  return result;
}

void MaterialResolver::assign(MappedMaterial& result, const parser::MaterialAssignment& assignment) {
  if (assign_extra(result, assignment) || assign_surface_map(result, assignment)) return;
  const ColorSlot slot = color_slot(result, assignment.parameter);
  if (const auto* map = std::get_if<parser::Apart<parser::MapFile>>(&assignment.value)) {
    const bool number =
        assignment.parameter == Parameter::index || assignment.parameter == Parameter::shininess;
    const TextureId id = textures_.open(**map, assignment.value_span, number);
    if (id == no_texture) return;
    if (slot.map) {
      *slot.map = id;
      if ((*map)->bare || !(*map)->over.empty()) result.on_any_surface = true;
      return;
    }
    *slot.value = Rgb(0);
    diagnostics_.warning(
        assignment.span,
        fmt::format("a map for '{}' has no effect: the surface stays {}", slot.name,
                    assignment.parameter == Parameter::reflective ? "without reflection" : "opaque"));
    return;
  }
  if (const auto* solid = std::get_if<parser::Apart<parser::SolidTexture>>(&assignment.value)) {
    if (slot.map) *slot.map = textures_.add(Texture(pattern_of(**solid)));
    return;
  }
  if (slot.map) *slot.map = no_texture;
  if (const auto* number = std::get_if<double>(&assignment.value)) {
    *slot.value = Rgb(*number);
  } else {
    const auto& color = std::get<std::array<double, 3>>(assignment.value);
    *slot.value = Rgb(color[0], color[1], color[2]);
  }
}

bool MaterialResolver::assign_surface_map(MappedMaterial& result,
                                          const parser::MaterialAssignment& assignment) {
  TextureId* slot = nullptr;
  if (assignment.parameter == Parameter::bump) slot = &result.bump;
  if (assignment.parameter == Parameter::normal) slot = &result.normal;
  if (!slot && assignment.parameter != Parameter::anisotropy) return false;
  if (!slot) {
    diagnostics_.warning(assignment.span, "a map of anisotropic highlights has no effect: they stay round");
  } else if (const auto* map = std::get_if<parser::Apart<parser::MapFile>>(&assignment.value)) {
    const TextureId id = textures_.open(**map, assignment.value_span, false);
    if (id != no_texture) *slot = id;
  }
  return true;
}

}  // namespace trace
