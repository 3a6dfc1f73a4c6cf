// Secondary rays as textbooks have them, to be compared with: from the computed point, whatever is nearer
// than a fixed 1e-8 in the space of the object does not count; double, and quadratics as they are printed.
#pragma once

#include "tests/hard/textbook_triangle.hpp"

namespace trace::hard {

inline constexpr double textbook_epsilon = 1e-8;

// Whether a ray, in the space of the object, meets it beyond the epsilon. Spheres, boxes, squares and meshes
// alone.
inline bool textbook_hits(const Scene& scene, const Shape& shape, const Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  if (std::holds_alternative<Sphere>(shape)) {
    const double b = 2 * glm::dot(o, d), c = glm::dot(o, o) - 1, discriminant = b * b - 4 * c;
    return discriminant >= 0 && (-b + std::sqrt(discriminant)) / 2 > textbook_epsilon;
  }
  if (std::holds_alternative<Square>(shape)) {
    const double t = -o.z / d.z;
    const Vec3 p = ray.at(t);
    return t > textbook_epsilon && std::abs(p.x) <= 0.5 && std::abs(p.y) <= 0.5;
  }
  if (std::holds_alternative<Box>(shape)) {
    const Vec3 a = (Vec3(-0.5) - o) / d, b = (Vec3(0.5) - o) / d, near = glm::min(a, b), far = glm::max(a, b);
    const double enter = std::max({near.x, near.y, near.z}), leave = std::min({far.x, far.y, far.z});
    return enter <= leave && leave > textbook_epsilon;
  }
  if (const auto* id = std::get_if<MeshId>(&shape)) {
    const Mesh& mesh = scene.meshes[id->index].geometry;
    double t = 0;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
      if (textbook_meets(mesh.corners(face), ray, t) && t > textbook_epsilon) return true;
    }
  }
  return false;
}

}  // namespace trace::hard
