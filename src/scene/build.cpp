#include "scene/build.hpp"

#include <map>

#include "scene/dialect_lights.hpp"
#include "scene/far_away.hpp"
#include "scene/few_warnings.hpp"
#include "scene/generated_mesh.hpp"
#include "scene/graph.hpp"
#include "scene/make_camera.hpp"
#include "scene/make_fog.hpp"
#include "scene/make_mesh.hpp"
#include "scene/make_shape.hpp"
#include "scene/make_surroundings.hpp"
#include "scene/material_maps.hpp"
#include "scene/material_resolver.hpp"
#include "scene/obj_meshes.hpp"
#include "scene/surface_maps.hpp"

namespace trace {
namespace {

Vec3 vector(const parser::Vector3& v) {
  return {v.value[0], v.value[1], v.value[2]};
}

class SceneBuilder {
 public:
  SceneBuilder(parser::Scene& description, const parser::Source& source, ImageSource& images,
               parser::Diagnostics& diagnostics)
      : description_(description),
        diagnostics_(diagnostics),
        folder_(source.directory()),
        images_(images),
        textures_(folder_, images, diagnostics, description.permissive),
        resolver_(textures_, diagnostics, rules_of(description.dialect)),
        camera_(diagnostics, rules_of(description.dialect)) {
    scene_.rules = rules_of(description.dialect);
  }

  Scene build() {
    for (const parser::Item& item : description_.items) {
      std::visit([&](const auto& what) { add(what); }, item);
    }
    scene_.camera = camera_.take();
    SceneGraph graph = make_graph(description_);
    scene_.frames = std::move(graph.frames);
    warn_of_singular(graph);
    FewWarnings far(diagnostics_, "{} more objects are as far out for their size");
    for (const GraphObject& object : graph.objects) {
      resolve_scopes(graph, object.scopes_before);
      add_object(object, far);
    }
    resolve_scopes(graph, graph.materials.size());  // for their errors
    scene_.textures = textures_.take();
    if (scene_.rules.texels_have_width) {
      for (Texture& texture : scene_.textures) texture.give_texels_width();
    }
    flatten_maps();
    return std::move(scene_);
  }

 private:
  // --- cameras and lights ---
  void add(const parser::Camera& camera) { camera_.add(camera); }

  void add(const parser::AmbientLight& light) { scene_.ambient += vector(light.color); }

  void add(const parser::DirectionalLight& light) {
    const Vec3 towards = -glm::normalize(vector(light.direction));
    scene_.lights.emplace_back(DirectionalLight{vector(light.color), towards});
  }

  void add(const parser::PointLight& light) {
    PointLight result{vector(light.color), vector(light.position)};
    if (light.constant) result.constant = static_cast<float>(light.constant->value);
    if (light.linear) result.linear = static_cast<float>(light.linear->value);
    if (light.quadratic) result.quadratic = static_cast<float>(light.quadratic->value);
    scene_.lights.emplace_back(result);
  }

  void add(const parser::DialectLight& light) {
    if (std::optional<Light> made = make_light(light, diagnostics_))
      scene_.lights.push_back(std::move(*made));
  }

  // Of several the last counts.
  void add(const parser::Surroundings& surroundings) {
    scene_.cube_map = make_surroundings(surroundings, folder_, images_, diagnostics_);
  }
  void add(const parser::Fog& fog) { scene_.fog = make_fog(fog, diagnostics_); }

  void add(const parser::Material&) {}  // part of the graph
  void add(parser::ElementId) {}        // part of the graph

  // --- materials ---
  struct ResolvedScope {
    MappedMaterial material;
    std::int64_t id = -1;  // in Scene::materials, once an object uses it
  };

  void resolve_scopes(const SceneGraph& graph, std::size_t count) {
    while (scopes_.size() < count) {
      const MaterialScope& scope = graph.materials[scopes_.size()];
      scopes_.push_back({resolver_.resolve(*scope.material, inherited(scope.inherits).material)});
    }
  }

  ResolvedScope& inherited(MaterialScopeId id) {
    return id == default_material ? default_ : scopes_[static_cast<std::size_t>(id)];
  }

  // As parser::VertexMaterials, resolved.
  struct VertexMaterials {
    std::vector<MappedMaterial> materials;
    std::vector<std::uint32_t> of;
  };
  static constexpr std::uint32_t unresolved = ~std::uint32_t{0};

  std::uint32_t add_material(const MappedMaterial& material) {
    scene_.materials.push_back(material);
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  }

  std::uint32_t material_of(const GraphObject& object) {
    ResolvedScope& base = inherited(object.inherits);
    const auto& own = object.primitive->materials;
    const auto maps = maps_beside(*object.primitive);
    if (own.empty() && !maps.empty()) return add_material(resolver_.with(base.material, maps));
    if (own.empty()) {
      if (base.id < 0) base.id = add_material(base.material);
      return static_cast<std::uint32_t>(base.id);
    }
    // Each is resolved for its errors and its name; the last one counts.
    own_materials_.clear();
    for (const parser::Material& material : own) {
      own_materials_.push_back(resolver_.resolve(material, base.material));
    }
    return add_material(maps.empty() ? own_materials_.back() : resolver_.with(own_materials_.back(), maps));
  }

  void note_transmission(const Material& material) {
    if (!material.transmits()) return;
    scene_.has_transmissive_objects = true;
    const Rgb& kt = material.transmissive;
    if (!(glm::all(glm::greaterThanEqual(kt, Rgb(0))) && glm::all(glm::lessThanEqual(kt, Rgb(1))))) {
      scene_.shadow_may_be_undefined = true;
    }
  }

  // In the language's core only boxes and squares have texture coordinates (docs/language.md section 9).
  bool has_texture_coordinates(const Object& object) const {
    const bool always = std::visit(
        [](const auto& s) {
          using S = std::decay_t<decltype(s)>;
          return std::is_same_v<S, Box> || std::is_same_v<S, Square> || std::is_same_v<S, Plane> ||
                 std::is_same_v<S, Torus> || std::is_same_v<S, Quadric>;
        },
        object.shape);
    if (always) return true;
    if (const auto* id = std::get_if<MeshId>(&object.shape))
      return scene_.meshes[id->index].geometry.has_coordinates();
    return description_.dialect != parser::Dialect::utexas ||
           scene_.materials[object.material].on_any_surface;
  }

  // Pictures on surfaces without texture coordinates become their constant, once all textures are open.
  void flatten_maps() {
    std::map<std::uint32_t, std::uint32_t> flattened;
    for (Object& object : scene_.objects) {
      const MappedMaterial material = scene_.materials[object.material];
      if (!material.has_maps() || has_texture_coordinates(object)) continue;
      auto [entry, is_new] = flattened.try_emplace(object.material, 0);
      if (is_new) entry->second = add_material(without_pictures(material, scene_.textures));
      object.material = entry->second;
    }
    for (const auto& [mesh, entries] : vertex_materials_) {
      const Mesh& geometry = scene_.meshes[mesh].geometry;
      if (geometry.has_coordinates() || has_solid_maps(entries)) {
        flatten_at_points(scene_.meshes[mesh], entries);
        continue;
      }
      std::vector<Material> distinct;
      distinct.reserve(entries.materials.size());
      for (const MappedMaterial& material : entries.materials) {
        distinct.push_back(at_point(material, scene_.textures, Vec2(0)));
        note_transmission(distinct.back());
      }
      std::vector<Material>& all = scene_.meshes[mesh].materials;
      all.reserve(entries.of.size());
      for (const std::uint32_t index : entries.of) all.push_back(distinct[index]);
    }
  }

  bool has_solid_maps(const VertexMaterials& entries) const {
    for (const MappedMaterial& material : entries.materials) {
      if (trace::has_solid_maps(material, scene_.textures)) return true;
    }
    return false;
  }

  // Where what a point is made of depends on where it is.
  void flatten_at_points(SceneMesh& mesh, const VertexMaterials& entries) {
    mesh.materials.reserve(entries.of.size());
    for (std::size_t i = 0; i < entries.of.size(); ++i) {
      const Vec2 uv = mesh.geometry.has_coordinates() ? repeated(mesh.geometry.coordinates[i]) : Vec2(0);
      mesh.materials.push_back(
          at_point(entries.materials[entries.of[i]], scene_.textures, uv, mesh.geometry.points[i]));
      note_transmission(mesh.materials.back());
    }
  }

  // --- objects ---
  void warn_of_singular(const SceneGraph& graph) {
    FewWarnings warnings(diagnostics_, "nothing inside {} more transforms is drawn");
    for (const SingularTransform& transform : graph.singular) {
      warnings.add(transform.keyword, transform.reason);
    }
  }

  void add_object(const GraphObject& object, FewWarnings& far) {
    const std::uint32_t material = material_of(object);
    const auto* mesh = std::get_if<parser::MeshId>(&object.primitive->shape);
    if (mesh && description_.meshes[mesh->index].file) return add_obj(object, *mesh, material, far);
    const std::optional<Shape> shape =
        std::visit([&](const auto& s) { return make_shape(s, object); }, object.primitive->shape);
    if (shape) place(object, *shape, material, far);
  }

  // One mesh for each of the file's materials.
  void add_obj(const GraphObject& object, parser::MeshId mesh, std::uint32_t material, FewWarnings& far) {
    const parser::Mesh& said = description_.meshes[mesh.index];
    const MappedMaterial inherits = scene_.materials[material];
    for (ObjObject& part :
         objects_of(*said.file, said.generate_normals, inherits, textures_, images_, diagnostics_)) {
      const std::uint32_t own = part.material ? add_material(*part.material) : material;
      if (const auto shape = add_mesh(std::move(part.mesh))) place(object, *shape, own, far);
    }
  }

  std::optional<Shape> add_mesh(Mesh mesh) {
    if (mesh.faces.empty()) return std::nullopt;
    scene_.meshes.push_back({std::move(mesh), {}});
    return MeshId{static_cast<std::uint32_t>(scene_.meshes.size() - 1)};
  }

  void place(const GraphObject& object, const Shape& shape, std::uint32_t material, FewWarnings& far) {
    if (object.frame < 0) return;
    const Mat4& to_world = scene_.frames[static_cast<std::size_t>(object.frame)].to_world;
    const Bounds local = local_bounds(shape);
    const Bounds bounds = transformed(local, to_world);
    if (bounds.empty()) return;
    if (const auto far_away = find_far_away(local, to_world)) {
      far.add(object.keyword, far_away->message(name_of(object.primitive->shape)));
    }
    note_transmission(scene_.materials[material].values);
    scene_.objects.push_back({shape, bounds, static_cast<std::uint32_t>(object.frame), material});
  }

  std::optional<Shape> make_shape(const parser::Sphere&, const GraphObject&) { return Sphere{}; }
  std::optional<Shape> make_shape(const parser::Box&, const GraphObject&) { return Box{}; }
  std::optional<Shape> make_shape(const parser::Square&, const GraphObject&) { return Square{}; }
  std::optional<Shape> make_shape(const parser::Cylinder& cylinder, const GraphObject&) {
    if (cylinder.capped && !cylinder.capped->value) return Tube{};
    return Cylinder{};
  }
  std::optional<Shape> make_shape(const parser::Plane& plane, const GraphObject&) {
    return make_plane(plane, diagnostics_);
  }
  std::optional<Shape> make_shape(const parser::Torus& torus, const GraphObject&) {
    return make_torus(torus, diagnostics_);
  }
  std::optional<Shape> make_shape(const parser::Quadric& quadric, const GraphObject&) {
    return make_quadric(quadric, diagnostics_);
  }

  std::optional<Shape> make_shape(const parser::TorusKnot& knot, const GraphObject&) {
    return add_mesh(generated_mesh(knot, diagnostics_));
  }
  std::optional<Shape> make_shape(const parser::HeightField& field, const GraphObject&) {
    return add_mesh(generated_mesh(field, textures_, diagnostics_));
  }

  std::optional<Shape> make_shape(const parser::Cone& cone, const GraphObject&) {
    return Cone(cone.bottom_radius ? cone.bottom_radius->value : 1,
                cone.top_radius ? cone.top_radius->value : 0, cone.height ? cone.height->value : 1,
                cone.capped ? cone.capped->value : true,
                scene_.rules.true_cones ? Cone::Habits::none : Cone::Habits::course);
  }

  std::optional<Shape> make_shape(const parser::MeshId& id, const GraphObject& object) {
    parser::Mesh& said = description_.meshes[id.index];
    VertexMaterials materials;
    materials.of.reserve(said.vertex_materials.count());
    for (const auto& [list, before] : said.material_lists) {
      const MappedMaterial own =
          before == 0 ? inherited(object.inherits).material : own_materials_[before - 1];
      std::vector<std::uint32_t> resolved(said.vertex_materials.materials.size(), unresolved);
      for (std::size_t i = 0; i < list.count; ++i) {
        const std::size_t index = said.vertex_materials.index(list.first + i);
        if (resolved[index] == unresolved) {
          resolved[index] = static_cast<std::uint32_t>(materials.materials.size());
          materials.materials.push_back(resolver_.resolve(said.vertex_materials.materials[index], own));
        }
        materials.of.push_back(resolved[index]);
      }
    }
    const std::optional<Shape> mesh =
        add_mesh(make_mesh(std::move(said), scene_.rules.unit_generated_normals));
    if (mesh && !materials.of.empty()) {
      vertex_materials_[std::get<MeshId>(*mesh).index] = std::move(materials);
    }
    return mesh;
  }

  Bounds local_bounds(const Shape& shape) const {
    if (const auto* mesh = std::get_if<MeshId>(&shape)) return scene_.meshes[mesh->index].geometry.bounds();
    return std::visit(
        [](const auto& s) -> Bounds {
          if constexpr (requires { s.bounds(); }) return s.bounds();
          return {};
        },
        shape);
  }

  parser::Scene& description_;
  parser::Diagnostics& diagnostics_;
  std::filesystem::path folder_;
  ImageSource& images_;
  TextureCache textures_;
  MaterialResolver resolver_;
  CameraMaker camera_;
  Scene scene_;
  ResolvedScope default_;
  std::vector<ResolvedScope> scopes_;
  std::vector<MappedMaterial> own_materials_;  // of the object that is being added
  std::map<std::uint32_t, VertexMaterials> vertex_materials_;
};

}  // namespace

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (const SceneMesh& mesh : meshes) count += mesh.geometry.faces.size();
  return count;
}

Scene build_scene(parser::Scene description, const parser::Source& source, ImageSource& images,
                  parser::Diagnostics& diagnostics) {
  return SceneBuilder(description, source, images, diagnostics).build();
}

}  // namespace trace
