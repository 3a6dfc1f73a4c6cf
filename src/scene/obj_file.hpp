// Wavefront OBJ files with their material files, as plain values: read by tinyobjloader, checked here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/vector.hpp"
#include "image/image_source.hpp"

namespace trace {

// Why a file could not be read: "no such file", "face 3 has a corner 9, but there are 8 points".
struct ObjError : std::runtime_error {
  using runtime_error::runtime_error;
};

// What a material file says: what it does not, is not there. Names of pictures are as written; empty for
// none.
struct ObjMaterial {
  std::string name;
  std::optional<Rgb> ambient, diffuse, specular, emissive, filter;  // Ka Kd Ks Ke Tf
  std::optional<double> shininess, index, opacity;                  // Ns Ni d (or 1 - Tr)
  std::string ambient_map, diffuse_map, specular_map, emissive_map, shininess_map, bump_map, normal_map;
};

// Indices into the lists of the file; `none` where the corner has no texture coordinates or no normal.
struct ObjCorner {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t point = 0, coordinates = none, normal = none;
};

struct ObjFile {
  static constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28;  // of one file
  static constexpr std::size_t longest_line = std::size_t{1} << 20;

  struct Face {
    std::size_t first_corner;
    std::uint32_t size;     // at least 3
    std::int32_t material;  // index into `materials`; -1 for none
  };
  std::vector<Vec3> points, normals;
  std::vector<Vec2> coordinates;
  std::vector<ObjCorner> corners;  // face after face
  std::vector<Face> faces;
  std::vector<ObjMaterial> materials;
  std::vector<std::string> warnings;  // "its material file 'x.mtl' cannot be read: no such file"
};

// Points, faces of any number of corners with their normals and texture coordinates, indices from 1 or, if
// negative, from the end of what has been read; materials by `usemtl` and `mtllib`, looked for beside the
// file. Faces of fewer than three corners, and all else that a file may hold, are passed over. Throws
// ObjError: no such file, one too long, a number that is not finite, an index that is out of range.
ObjFile read_obj(const std::filesystem::path& path, ImageSource& images);

}  // namespace trace
