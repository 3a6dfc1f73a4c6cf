// Runtime scenes made by hand, without any text.
#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.hpp"

namespace trace::test {

inline Mat4 at_origin() {
  return Mat4(1);
}
inline Mat4 moved(double x, double y, double z) {
  return glm::translate(Mat4(1), Vec3(x, y, z));
}
inline Mat4 scaled(double x, double y, double z) {
  return glm::scale(Mat4(1), Vec3(x, y, z));
}
inline Mat4 scaled(double s) {
  return scaled(s, s, s);
}
inline Mat4 turned(double angle, double x, double y, double z) {
  return glm::rotate(Mat4(1), angle, Vec3(x, y, z));
}

// Adds an object and keeps the scene's promises: bounds, and whether light can pass.
void add(Scene& scene, const Shape& shape, const Mat4& place, const Material& material);
void add(Scene& scene, const Shape& shape, const Mat4& place, const MappedMaterial& material);

// `vertex_materials`: none, or one a point.
void add(Scene& scene, const Mesh& mesh, const Mat4& place, const Material& material,
         const std::vector<Material>& vertex_materials = {});

// The triangle (-1,-1,0) (1,-1,0) (0,1,0), seen from its front along -z; or from its front along +z.
Mesh front_triangle();
Mesh back_triangle();

// Materials with one parameter each, and both of two (for parameters only one of them has).
Material emissive(const Rgb& color);
Material ambient(const Rgb& color);
Material diffuse(const Rgb& color);
Material specular(const Rgb& color, double shininess);
Material reflective(const Rgb& color);
Material transmissive(const Rgb& color, double index = 1);
Material operator+(const Material& a, const Material& b);

DirectionalLight directional(const Vec3& direction, const Rgb& color = Rgb(1));

}  // namespace trace::test
