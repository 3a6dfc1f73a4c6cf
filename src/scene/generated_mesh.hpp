// Meshes that are made of what the file says, not listed in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/material.hpp"
#include "scene/texture_cache.hpp"

namespace trace {

// Empty, with an error, where the knot has no extent or winds too often.
Mesh generated_mesh(const parser::TorusKnot& said, parser::Diagnostics& diagnostics);

// Empty, with an error, where there is no height map or it cannot be read. It is found as bare strings are
// (SceneFiles::find_somewhere).
Mesh generated_mesh(const parser::HeightField& said, TextureCache& textures,
                    parser::Diagnostics& diagnostics);

// What a primitive's material is assigned beside it: its maps, and of a height field its colours, which it
// emits.
std::vector<parser::MaterialAssignment> maps_beside(const parser::Primitive& primitive);

// A part of an OBJ file; without a material it has the scene's.
struct ObjObject {
  Mesh mesh;
  std::optional<MappedMaterial> material;
};

// `inherits` is what its materials say less than all on top of. None, with an error at the name, where the
// file cannot be read; what the file lacks otherwise are warnings there.
std::vector<ObjObject> objects_of(const parser::Name& file, bool generate_normals,
                                  const MappedMaterial& inherits, TextureCache& textures, ImageSource& images,
                                  parser::Diagnostics& diagnostics);

}  // namespace trace
