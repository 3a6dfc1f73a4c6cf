#include "tests/support/scene_make.hpp"

namespace trace::test {
namespace {

Bounds local_bounds(const Scene& scene, const Shape& shape) {
  if (const auto* mesh = std::get_if<MeshId>(&shape)) return scene.meshes[mesh->index].geometry.bounds();
  return std::visit(
      [](const auto& s) -> Bounds {
        if constexpr (requires { s.bounds(); }) return s.bounds();
        return {};
      },
      shape);
}

void note(Scene& scene, const Material& material) {
  if (material.transmits()) scene.has_transmissive_objects = true;
  for (int channel = 0; channel < 3; ++channel) {
    const double kt = material.transmissive[channel];
    if (kt < 0 || kt > 1) scene.shadow_may_be_undefined = true;
  }
}

}  // namespace

void add(Scene& scene, const Shape& shape, const Mat4& place, const MappedMaterial& material) {
  note(scene, material.values);
  const auto index = static_cast<std::uint32_t>(scene.frames.size());
  scene.frames.emplace_back(place);
  scene.materials.push_back(material);
  scene.objects.push_back({shape, transformed(local_bounds(scene, shape), place), index,
                           static_cast<std::uint32_t>(scene.materials.size() - 1)});
}

void add(Scene& scene, const Shape& shape, const Mat4& place, const Material& material) {
  MappedMaterial without_maps;
  without_maps.values = material;
  add(scene, shape, place, without_maps);
}

void add(Scene& scene, const Mesh& mesh, const Mat4& place, const Material& material,
         const std::vector<Material>& vertex_materials) {
  for (const Material& m : vertex_materials) note(scene, m);
  scene.meshes.push_back({mesh, vertex_materials});
  add(scene, Shape(MeshId{static_cast<std::uint32_t>(scene.meshes.size() - 1)}), place, material);
}

Mesh front_triangle() {
  Mesh mesh;
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

Mesh back_triangle() {
  Mesh mesh = front_triangle();
  mesh.faces = {{0, 2, 1}};
  return mesh;
}

Material emissive(const Rgb& color) {
  Material m;
  m.emissive = color;
  return m;
}

Material ambient(const Rgb& color) {
  Material m;
  m.ambient = color;
  return m;
}

Material diffuse(const Rgb& color) {
  Material m;
  m.diffuse = color;
  return m;
}

Material specular(const Rgb& color, double shininess) {
  Material m;
  m.specular = color;
  m.shininess = Rgb(shininess);
  return m;
}

Material reflective(const Rgb& color) {
  Material m;
  m.reflective = color;
  return m;
}

Material transmissive(const Rgb& color, double index) {
  Material m;
  m.transmissive = color;
  m.index = Rgb(index);
  return m;
}

Material operator+(const Material& a, const Material& b) {
  Material sum = mix(a, b, Material{}, 1, 1, 0);
  sum.index = a.index + b.index - Rgb(1);  // one is the index of a material that says none
  return sum;
}

DirectionalLight directional(const Vec3& direction, const Rgb& color) {
  return {color, -glm::normalize(direction)};
}

}  // namespace trace::test
