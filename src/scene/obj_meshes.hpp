// From an OBJ file to the meshes and materials of a scene.
#pragma once

#include "geometry/mesh.hpp"
#include "scene/material.hpp"
#include "scene/obj_file.hpp"
#include "scene/texture_cache.hpp"

namespace trace {

// The faces of one material.
struct ObjPart {
  Mesh mesh;
  std::int32_t material;  // index into ObjFile::materials; -1 for none
};

// In the order in which their materials come. Polygons become fans. Points that faces give different normals
// or texture coordinates are split. A part has normals, or texture coordinates, where all of its corners do;
// with `generate` one without normals gets them at each point of the file: the sum of the unit normals of the
// faces around it, which belong to the part, by their number.
std::vector<ObjPart> parts_of(const ObjFile& file, bool generate);

// `inherited` with what the material file says on top:
//
//   Kd Ka Ks Ke  diffuse ambient specular emissive     Ns  shininess     Ni  index
//   d            transmissive = (1 - d) Tf, where Tf is (1, 1, 1) unless given; Tr is 1 - d. Without d or Tr
//                nothing changes.
//   map_Kd map_Ka map_Ks map_Ke map_Ns map_Bump (bump) norm   maps, instead of the value
//
// Pictures are looked for in `folder`, relative to the scene's; for one that cannot be read a warning is
// added and its value stays.
MappedMaterial material_of(const ObjMaterial& said, const MappedMaterial& inherited,
                           const std::filesystem::path& folder, TextureCache& textures,
                           std::vector<std::string>& warnings);

}  // namespace trace
