#include "scene/generated_mesh.hpp"

#include <fmt/format.h>

#include "scene/few_warnings.hpp"
#include "scene/height_field.hpp"
#include "scene/obj_meshes.hpp"
#include "scene/torus_knot.hpp"

namespace trace {
namespace {

void take(const std::optional<parser::Scalar>& said, double& value) {
  if (said) value = said->value;
}

// An error; with permissive reading a warning.
void cannot_read(const std::string& what, const std::string& problem, parser::Span span, bool permissive,
                 parser::Diagnostics& diagnostics) {
  const std::string message = fmt::format("cannot read {}: {}", what, problem);
  if (permissive) {
    diagnostics.warning(span, message + ": this object is left out");
  } else {
    diagnostics.error(span, message);
  }
}

}  // namespace

Mesh generated_mesh(const parser::TorusKnot& said, parser::Diagnostics& diagnostics) {
  TorusKnot knot;
  take(said.radius, knot.radius);
  take(said.tube, knot.tube);
  take(said.p, knot.p);
  take(said.q, knot.q);
  const std::size_t errors = diagnostics.error_count();
  // The defaults are good: what is not was said.
  if (!(knot.radius > 0))
    diagnostics.error(said.radius->span, "the radius of a torus_knot must be more than 0");
  if (!(knot.tube > 0)) diagnostics.error(said.tube->span, "the tube of a torus_knot must be more than 0");
  if (!(std::abs(knot.q) <= TorusKnot::most_q)) {
    diagnostics.error(said.q->span,
                      fmt::format("the q of a torus_knot must be from -{0} to {0}", TorusKnot::most_q));
  }
  return diagnostics.error_count() == errors ? make_torus_knot(knot) : Mesh();
}

Mesh generated_mesh(const parser::HeightField& said, TextureCache& textures,
                    parser::Diagnostics& diagnostics) {
  if (!said.height_map) return {};  // the parser has said so
  std::string problem;
  const std::optional<Texture> heights = textures.picture(said.height_map->value, problem);
  if (!heights) {
    cannot_read(fmt::format("height map '{}'", said.height_map->value), problem, said.height_map->span,
                textures.permissive(), diagnostics);
    return {};
  }
  return make_height_field(*heights, said.generate_normals);
}

std::vector<parser::MaterialAssignment> maps_beside(const parser::Primitive& primitive) {
  std::vector<parser::MaterialAssignment> result = primitive.maps;
  const auto* field = std::get_if<parser::HeightField>(&primitive.shape);
  if (field && field->color_map) {
    const parser::Span span = field->color_map->span;
    result.push_back(
        {parser::Parameter::emissive, parser::MapFile{field->color_map->value, true}, span, span});
  }
  return result;
}

std::vector<ObjObject> objects_of(const parser::Name& file, bool generate_normals,
                                  const MappedMaterial& inherits, TextureCache& textures, ImageSource& images,
                                  parser::Diagnostics& diagnostics) {
  std::vector<ObjObject> result;
  try {
    const std::filesystem::path path = textures.files().find(file.value);
    const ObjFile obj = read_obj(path, images);
    const std::filesystem::path folder = path.parent_path().lexically_relative(textures.files().folder());
    std::vector<std::string> problems = obj.warnings;
    std::vector<MappedMaterial> materials;
    for (const ObjMaterial& said : obj.materials) {
      materials.push_back(material_of(said, inherits, folder, textures, problems));
    }
    for (ObjPart& part : parts_of(obj, generate_normals)) {
      ObjObject object{std::move(part.mesh), std::nullopt};
      if (part.material >= 0) object.material = materials[static_cast<std::size_t>(part.material)];
      result.push_back(std::move(object));
    }
    if (result.empty()) problems.push_back("it has no faces");
    FewWarnings warnings(diagnostics, "{} more things are amiss with this file");
    for (const std::string& problem : problems) {
      warnings.add(file.span, fmt::format("'{}': {}", file.value, problem));
    }
  } catch (const ObjError& e) {
    cannot_read(fmt::format("'{}'", file.value), e.what(), file.span, textures.permissive(), diagnostics);
  }
  return result;
}

}  // namespace trace
