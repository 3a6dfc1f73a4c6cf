// The runtime scene: everything composed, inherited and resolved, ready to be searched and shaded.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/cone.hpp"
#include "geometry/cylinder.hpp"
#include "geometry/frame.hpp"
#include "geometry/mesh.hpp"
#include "geometry/plane.hpp"
#include "geometry/quadric.hpp"
#include "geometry/sphere.hpp"
#include "geometry/square.hpp"
#include "geometry/torus.hpp"
#include "scene/camera.hpp"
#include "scene/cube_map.hpp"
#include "scene/dialect_rules.hpp"
#include "scene/fog.hpp"
#include "scene/light.hpp"
#include "scene/material.hpp"
#include "scene/texture.hpp"

namespace trace {

// Index into Scene::meshes.
struct MeshId {
  std::uint32_t index;
};

// Those up to Cone have packet kernels of their own; the others are asked ray by ray (shape.hpp).
using Shape = std::variant<Sphere, Box, Square, Cylinder, Cone, MeshId, Tube, Plane, Torus, Quadric>;

struct Object {
  Shape shape;
  Bounds bounds;           // in the world; may be unbounded
  std::uint32_t frame;     // index into Scene::frames
  std::uint32_t material;  // index into Scene::materials
};

// A mesh and, where it has `materials`, one a point.
struct SceneMesh {
  Mesh geometry;
  std::vector<Material> materials;

  // Mixed from those of a face's corners; `weights` are of the second and third.
  Material material_at(std::uint32_t face, const Vec2& weights) const {
    const FaceCorners& f = geometry.faces[face];
    const double u = weights.x, v = weights.y;
    return mix(materials[f[0]], materials[f[1]], materials[f[2]], 1.0 - u - v, u, v);
  }
};

// Objects are in file order: of two hits at the same t the earlier object's counts. Where an object's
// material has maps, they lie on it by its texture coordinates.
struct Scene {
  DialectRules rules;
  Camera camera;
  Rgb ambient{0};  // all ambient lights together
  std::vector<Light> lights;
  std::vector<Object> objects;
  std::vector<Frame> frames;
  std::vector<SceneMesh> meshes;
  std::vector<MappedMaterial> materials;
  std::vector<Texture> textures;
  std::optional<CubeMap> cube_map;
  std::optional<Fog> fog;

  // Whether any light can pass any object, so that shadows have to be followed through glass.
  bool has_transmissive_objects = false;
  // Whether a shadow can be infinite or undefined (transmission that is negative or above one), so that a
  // surface that reflects nothing of a light may still turn black.
  bool shadow_may_be_undefined = false;

  std::size_t triangle_count() const;
};

}  // namespace trace
