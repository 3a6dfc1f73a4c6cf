#include "shading/surface.hpp"

#include "scene/material_maps.hpp"

namespace trace {
namespace {

Material mixed(const SceneMesh& mesh, const LocalHit& hit) {
  const FaceCorners& face = mesh.geometry.faces[hit.part];
  const double u = hit.uv.x, v = hit.uv.y;
  return mix(mesh.materials[face[0]], mesh.materials[face[1]], mesh.materials[face[2]], 1.0 - u - v, u, v);
}

}  // namespace

Surface::Surface(const Scene& scene, const Ray& ray, const Hit& hit, bool smooth) : point_(ray.at(hit.t)) {
  const Object& object = scene.objects[hit.object];
  const MappedMaterial& material = scene.materials[object.material];
  material_ = &material.values;
  Vec3 normal = hit.local.normal;
  if (const auto* id = std::get_if<MeshId>(&object.shape)) {
    const SceneMesh& mesh = scene.meshes[id->index];
    normal = smooth && mesh.geometry.smooth() ? mesh.geometry.smooth_normal(hit.local.part, hit.local.uv)
                                              : face_normal(mesh.geometry.triangle(hit.local.part));
    if (!mesh.materials.empty()) {
      own_ = mixed(mesh, hit.local);
      material_ = &own_;
    }
  } else if (material.has_maps()) {
    own_ = at_point(material, scene.textures, hit.local.uv);
    material_ = &own_;
  }
  normal_ = scene.frames[object.frame].world_normal(normal);
}

}  // namespace trace
