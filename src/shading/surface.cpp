#include "shading/surface.hpp"

#include <algorithm>

#include "geometry/rounding.hpp"
#include "scene/material_maps.hpp"
#include "scene/shape.hpp"
#include "scene/surface_maps.hpp"

namespace trace {
namespace {

Vec3 point_in(const Scene& scene, const Object& object, const Vec3& point) {
  return Vec3(scene.frames[object.frame].to_object * Vec4(point, 1));
}

// Bound on the distance of a hit's point from the surface that was hit, as a displacement in each coordinate
// of the world. It is measured rather than derived from how the point came about: carry the point into the
// space of the object, which is off by a known bound, and see how far from the surface it is there.
double height_of_point(const Scene& scene, const Object& object, const LocalHit& hit, const Vec3& point) {
  const Frame& frame = scene.frames[object.frame];
  const Vec3 p = point_in(scene, object, point);
  const double distance = std::visit(
      [&](const auto& shape) {
        using S = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<S, MeshId>) {
          return scene.meshes[shape.index].geometry.distance(hit.part, p);
        } else if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, Square>) {
          return shape.distance(p) + gamma(4);
        } else {
          return shape.distance(p, hit.normal) + gamma(4) * (1 + largest(p));
        }
      },
      object.shape);
  return frame.to_world_stretch * (distance + frame.error(largest(point)));
}

}  // namespace

Surface::Surface(const Scene& scene, const Ray& ray, const Hit& hit, bool smooth, bool always_maps)
    : point_(ray.at(hit.t)), least_way_(scene.rules.least_way) {
  const Object& object = scene.objects[hit.object];
  const MappedMaterial& material = scene.materials[object.material];
  material_ = &material.values;
  given_ = &material;
  Vec3 normal = hit.local.normal, facing = normal;
  if (const auto* id = std::get_if<MeshId>(&object.shape)) {
    const SceneMesh& mesh = scene.meshes[id->index];
    facing = face_normal(mesh.geometry.triangle(hit.local.part));
    normal =
        smooth && mesh.geometry.smooth() ? mesh.geometry.smooth_normal(hit.local.part, hit.local.uv) : facing;
    if (!mesh.materials.empty()) {
      own_ = mesh.material_at(hit.local.part, hit.local.uv);
      material_ = &own_;
    }
  } else if (const auto* cone = std::get_if<Cone>(&object.shape)) {
    facing = cone->facing(normal);
  }
  if (evaluates_maps(scene, object, always_maps)) {
    const Vec3 p = point_in(scene, object, point_);
    own_ = at_point(material, scene.textures, texture_coordinates(scene, object, hit.local, p), p);
    material_ = &own_;
  }
  const Frame& frame = scene.frames[object.frame];
  normal_ = frame.world_normal(normal);
  facing_ = normal == facing ? normal_ : frame.world_normal(facing);
  if (material.turns_normals()) {
    normal_ =
        mapped_normal(scene, object, hit.local, point_in(scene, object, point_), normal_, ray.direction);
  }
  height_ = height_of_point(scene, object, hit.local, point_);
  // Where the point should be is further on or back along the ray.
  point_error_ = height_ / std::max(std::abs(glm::dot(facing_, ray.direction)), least_cosine);
}

Ray Surface::leaving(const Vec3& direction) const {
  // Along the normal the point is off by at most sqrt(3) of the height in each coordinate, and the surface
  // that the ray leaves by as much again: up to there all is one. A ray that does not rise at all, as far as
  // its direction tells, runs in the surface and meets what stands at its edge, as in the course's pictures.
  const double cosine = std::abs(glm::dot(facing_, direction));
  const double least_t = cosine > least_cosine ? 4 * height_ / cosine : 0;
  return {point_, direction, point_error_, std::max(least_t, least_way_)};
}

}  // namespace trace
