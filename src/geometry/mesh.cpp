#include "geometry/mesh.hpp"

#include "geometry/rounding.hpp"

namespace trace {

double Mesh::distance(std::uint32_t face, const Vec3& p) const {
  const Corners at = corners(face);
  const Vec3 ab = at.b - at.a, ac = at.c - at.a, from_a = p - at.a;
  const Vec3 normal = glm::cross(ab, ac);
  // Edges, their products, the way from a, the sum and the length of a normal that may be much shorter than
  // the products of which it is the difference: less than 32 roundings, of products no larger than these.
  const double error = gamma(16) * 2 * largest(ab) * largest(ac) * sum_of_sizes(from_a);
  return (std::abs(glm::dot(from_a, normal)) + error) / glm::length(normal);
}

Bounds Mesh::bounds() const {
  Bounds result;
  for (const Vec3& p : points) result.add(p);
  return result;
}

Vec3 Mesh::smooth_normal(std::uint32_t face, const Vec2& weights) const {
  const FaceCorners& f = faces[face];
  const double u = weights.x, v = weights.y;
  return glm::normalize((1.0 - u - v) * normals[f[0]] + u * normals[f[1]] + v * normals[f[2]]);
}

Vec2 Mesh::coordinates_at(std::uint32_t face, const Vec2& weights) const {
  const FaceCorners& f = faces[face];
  const double u = weights.x, v = weights.y;
  return (1.0 - u - v) * coordinates[f[0]] + u * coordinates[f[1]] + v * coordinates[f[2]];
}

std::optional<Tangents> Mesh::tangents(std::uint32_t face) const {
  const FaceCorners& f = faces[face];
  const Vec3 ab = points[f[1]] - points[f[0]], ac = points[f[2]] - points[f[0]];
  const Vec2 uv_b = coordinates[f[1]] - coordinates[f[0]], uv_c = coordinates[f[2]] - coordinates[f[0]];
  // ab = uv_b.x along_u + uv_b.y along_v, and likewise ac. Times the determinant, of which only the sign is
  // needed: lengths do not count.
  const double determinant = uv_b.x * uv_c.y - uv_b.y * uv_c.x;
  if (!(determinant != 0)) return std::nullopt;
  const double sign = determinant < 0 ? -1 : 1;
  return checked({sign * (uv_c.y * ab - uv_b.y * ac), sign * (uv_b.x * ac - uv_c.x * ab)});
}

void add_polygon(Mesh& mesh, const std::uint32_t* corners, std::uint32_t count) {
  for (std::uint32_t k = 2; k < count; ++k) {
    const FaceCorners face{corners[0], corners[k - 1], corners[k]};
    const Vec3 &a = mesh.points[face[0]], &b = mesh.points[face[1]], &c = mesh.points[face[2]];
    if (a != b && b != c && a != c) mesh.faces.push_back(face);
  }
}

void generate_normals(Mesh& mesh) {
  std::vector<std::uint32_t> face_count(mesh.points.size(), 0);
  mesh.normals.resize(mesh.points.size(), Vec3(0));
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const Vec3 normal = face_normal(mesh.triangle(face));
    for (const std::uint32_t corner : mesh.faces[face]) {
      mesh.normals[corner] += normal;
      ++face_count[corner];
    }
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (face_count[i] > 0) mesh.normals[i] /= static_cast<double>(face_count[i]);
  }
}

void normalize_normals(Mesh& mesh) {
  for (Vec3& normal : mesh.normals) {
    if (!is_zero(normal)) normal = glm::normalize(normal);
  }
}

}  // namespace trace
