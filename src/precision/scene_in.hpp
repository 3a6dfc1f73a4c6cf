// A scene carried to a kind of number, once before any ray.
#pragma once

#include <stdexcept>
#include <variant>
#include <vector>

#include "precision/cone.hpp"
#include "precision/triangle.hpp"
#include "scene/scene.hpp"

namespace trace::precision {

template <class T>
struct CameraIn {
  Vec3<T> eye, look, u, v;  // u and v are the window's edges

  explicit CameraIn(const Camera& camera)
      : eye(camera.eye),
        look(camera.look),
        u(Vec3<T>(camera.right) * static_cast<T>(camera.window_height) * static_cast<T>(camera.aspect)),
        v(Vec3<T>(camera.up) * static_cast<T>(camera.window_height)) {}

  // (0, 0) is the lower left corner of the picture, (1, 1) the upper right.
  Ray<T> cast(T x, T y) const { return {eye, glm::normalize(look + (x - T(0.5)) * u + (y - T(0.5)) * v)}; }
};

// A place. Normals go to the world by the transpose of the inverse.
template <class T>
struct FrameIn {
  Mat4<T> to_object;
  glm::mat<3, 3, T, glm::defaultp> normal_to_world;

  explicit FrameIn(const Frame& frame)
      : to_object(frame.to_object),
        normal_to_world(glm::transpose(glm::mat<3, 3, T, glm::defaultp>(to_object))) {}

  Vec3<T> point_to_object(const Vec3<T>& p) const { return Vec3<T>(to_object * Vec4<T>(p, 1)); }
  // In each coordinate: the sum of the sizes of the terms of point_to_object(p).
  Vec3<T> terms_of_point(const Vec3<T>& p) const {
    return glm::abs(Vec3<T>(to_object[0])) * std::abs(p.x) + glm::abs(Vec3<T>(to_object[1])) * std::abs(p.y) +
           glm::abs(Vec3<T>(to_object[2])) * std::abs(p.z) + glm::abs(Vec3<T>(to_object[3]));
  }
};

template <class T>
BasicMaterial<T> material_in(const Material& m) {
  using Color = Vec3<T>;
  return {Color(m.emissive),   Color(m.ambient),      Color(m.diffuse), Color(m.specular),
          Color(m.reflective), Color(m.transmissive), Color(m.index),   Color(m.shininess)};
}

template <class T>
struct MeshIn {
  const Mesh* given;  // whose faces these are
  std::vector<Vec3<T>> points, normals;
  std::vector<BasicMaterial<T>> materials;  // empty or one a point

  explicit MeshIn(const SceneMesh& mesh)
      : given(&mesh.geometry),
        points(mesh.geometry.points.begin(), mesh.geometry.points.end()),
        normals(mesh.geometry.normals.begin(), mesh.geometry.normals.end()) {
    materials.reserve(mesh.materials.size());
    for (const Material& m : mesh.materials) materials.push_back(material_in<T>(m));
  }

  Triangle<T> triangle(const FaceCorners& f) const { return {points[f[0]], points[f[1]], points[f[2]]}; }
  Vec3<T> smooth_normal(const FaceCorners& f, const Vec2<T>& w) const {
    return glm::normalize((1 - w.x - w.y) * normals[f[0]] + w.x * normals[f[1]] + w.y * normals[f[2]]);
  }
  BasicMaterial<T> material_at(const FaceCorners& f, const Vec2<T>& w) const {
    return mix(materials[f[0]], materials[f[1]], materials[f[2]], 1 - w.x - w.y, w.x, w.y);
  }
};

template <class T>
using ShapeIn = std::variant<Sphere, Box, Square, Cylinder, ConeIn<T>, MeshId>;

template <class T>
struct ObjectIn {
  ShapeIn<T> shape;
  Vec3<T> low, high;  // its box in the world
  std::uint32_t frame, material;

  explicit ObjectIn(const Object& object)
      : shape(std::visit(
            [](const auto& s) -> ShapeIn<T> {
              if constexpr (std::is_same_v<std::decay_t<decltype(s)>, Cone>) {
                return ConeIn<T>(s);
              } else if constexpr (std::is_constructible_v<ShapeIn<T>, decltype(s)>) {
                return s;
              } else {
                throw std::invalid_argument("a shape that the plain tracer does not know");
              }
            },
            object.shape)),
        low(object.bounds.min),
        high(object.bounds.max),
        frame(object.frame),
        material(object.material) {}
};

// Lights, textures and the cube map are asked where they are.
template <class T>
struct SceneIn {
  const Scene& given;
  CameraIn<T> camera;
  Vec3<T> ambient;
  std::vector<ObjectIn<T>> objects;
  std::vector<FrameIn<T>> frames;
  std::vector<MeshIn<T>> meshes;
  std::vector<BasicMappedMaterial<T>> materials;

  explicit SceneIn(const Scene& scene)
      : given(scene),
        camera(scene.camera),
        ambient(scene.ambient),
        objects(scene.objects.begin(), scene.objects.end()),
        frames(scene.frames.begin(), scene.frames.end()),
        meshes(scene.meshes.begin(), scene.meshes.end()) {
    for (const MappedMaterial& m : scene.materials) {
      materials.push_back(
          {material_in<T>(m.values), m.emissive, m.ambient, m.diffuse, m.specular, m.index, m.shininess});
    }
  }
};

}  // namespace trace::precision
