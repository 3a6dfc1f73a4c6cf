// Triangle meshes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/bounds.hpp"
#include "geometry/tangents.hpp"
#include "geometry/triangle.hpp"

namespace trace {

using FaceCorners = std::array<std::uint32_t, 3>;

// Points and, where it is smooth, a normal a point (as given, not of unit length); where it has places in
// textures, one a point. Faces are in file order;
// polygons have been cut into fans and faces with two equal corners dropped.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  // empty or one a point
  std::vector<FaceCorners> faces;
  std::vector<Vec2> coordinates{};  // of textures; empty or one a point

  bool smooth() const { return !normals.empty(); }
  bool has_coordinates() const { return !coordinates.empty(); }
  Corners corners(const FaceCorners& f) const { return {points[f[0]], points[f[1]], points[f[2]]}; }
  Corners corners(std::uint32_t face) const { return corners(faces[face]); }
  Triangle triangle(std::uint32_t face) const { return Triangle(corners(face)); }
  Bounds bounds() const;  // of all points, used by a face or not

  // Of a point from the plane of a face, at least as much as the real one.
  double distance(std::uint32_t face, const Vec3& p) const;

  // Interpolated: n = normalize((1-u-v) n_a + u n_b + v n_c). Not finite where the sum is zero.
  Vec3 smooth_normal(std::uint32_t face, const Vec2& weights) const;

  // Interpolated in the same way.
  Vec2 coordinates_at(std::uint32_t face, const Vec2& weights) const;
  // How the points of a face go with its texture coordinates; nothing where those of the corners lie on a
  // line, or the corners do.
  std::optional<Tangents> tangents(std::uint32_t face) const;
};

// Appends the fan (v0, v[k-1], v[k]) of a polygon, leaving out faces with two corners at the same place.
void add_polygon(Mesh& mesh, const std::uint32_t* corners, std::uint32_t count);

// `gennormals`: the normal of a point becomes (its given normal, if any, + the sum of the unit normals of the
// faces around it) / the number of those faces. A face without area makes the normals of its corners
// undefined.
void generate_normals(Mesh& mesh);

// Makes every vertex normal one of unit length, but for those of length zero.
void normalize_normals(Mesh& mesh);

}  // namespace trace
