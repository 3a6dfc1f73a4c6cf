// What a scene file says, as plain values with their places: the parser's result and the only thing that
// `src/` takes from it. It holds no geometry: nothing is composed, inherited, resolved or opened here.
//
// Order is kept where the language gives it a meaning: a `material =` affects what follows it. Elements live
// in one flat array and refer to one another by index, so that a scene nested 100 000 deep is built, walked
// and destroyed without recursion.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "parser/source.hpp"

namespace trace::parser {

template <class T>
struct Located {
  T value{};
  Span span;
};

using Scalar = Located<double>;
using Vector3 = Located<std::array<double, 3>>;
using Vector4 = Located<std::array<double, 4>>;
using Name = Located<std::string>;

// --- materials ---------------------------------------------------------------------------------------------

enum class Parameter : std::uint8_t {
  emissive,
  ambient,
  diffuse,
  specular,
  reflective,
  transmissive,  // colours
  index,
  shininess  // numbers
};

struct MapFile {
  std::string file;  // as written in map("file")
};

// One `parameter = value` of a material. `value` is a number for index and shininess, three for the colours,
// or the file of a map for either.
struct MaterialAssignment {
  Parameter parameter{};
  std::variant<double, std::array<double, 3>, MapFile> value;
  Span span;        // the whole assignment
  Span value_span;  // its right-hand side
};

// `{ ... }`: in file order; a later assignment of a parameter replaces an earlier one; what is not assigned
// is inherited where the material is used.
struct MaterialBlock {
  std::vector<MaterialAssignment> assignments;
  std::optional<Name> name;  // registers the block under this name
};

// The right-hand side of `material =`: a block, or the name of one registered earlier in the file.
struct Material {
  std::variant<MaterialBlock, Name> value;
  Span span;
};

// The materials of a mesh's points: entry i is materials[of[i]], so that one that is written many times over
// is held once. `of` may be left empty where every entry has a material of its own.
struct VertexMaterials {
  std::vector<Material> materials;
  std::vector<std::uint32_t> of;

  std::size_t count() const { return of.empty() ? materials.size() : of.size(); }
  std::size_t index(std::size_t entry) const { return of.empty() ? entry : of[entry]; }

  void add(Material material) {
    of.push_back(static_cast<std::uint32_t>(materials.size()));
    materials.push_back(std::move(material));
  }
  void append(VertexMaterials more);  // both with `of`
};

// --- cameras and lights ------------------------------------------------------------------------------------

// One camera block. Blocks accumulate: an attribute of a later block replaces that of an earlier one.
// viewdir and updir are both given or both absent.
struct Camera {
  std::optional<Vector3> position, viewdir, updir;
  std::optional<Scalar> fov, aspectratio;
  std::optional<Vector4> quaternion;
  Span span;
};

struct AmbientLight {
  Vector3 color;
  Span span;
};

struct DirectionalLight {
  Vector3 direction, color;
  Span span;
};

struct PointLight {
  Vector3 position, color;
  std::optional<Scalar> constant, linear, quadratic;  // attenuation coefficients
  Span span;
};

// --- elements ----------------------------------------------------------------------------------------------

// One list `points = (...)`, `normals = (...)`, ... of a mesh: entries [first, first + count) of the flat
// array. An entry is a number of `points` and `normals` (three a point), an index of `corners`, a material.
// The place of one number is found by reading the list's text again (number_span in parser/list_reader.hpp);
// errors are rare.
struct ListSpan {
  std::uint64_t first = 0, count = 0;
  Span span;  // from '(' to ')'
};

// One list `materials = (...)` of a mesh: its entries inherit from the mesh's material as it stood there,
// which is the last of the first `materials_before` of Primitive::materials.
struct MaterialList {
  ListSpan list;  // entries of Mesh::vertex_materials, counted as VertexMaterials::of counts them
  std::size_t materials_before = 0;
};

// trimesh and polymesh. All indices are checked: every corner is less than the number of points, every face
// has at least three corners, normals and materials are as many as the points or none.
struct Mesh {
  std::vector<double> points;             // 3 numbers a point
  std::vector<double> normals;            // 3 numbers a normal
  std::vector<std::uint32_t> corners;     // indices into points, face after face
  std::vector<std::uint32_t> face_sizes;  // corners of each face; empty when every face is a triangle
  VertexMaterials vertex_materials;
  bool generate_normals = false;

  std::vector<ListSpan> point_lists, normal_lists, face_lists;
  std::vector<MaterialList> material_lists;
};

struct Cone {
  std::optional<Located<bool>> capped;
  std::optional<Scalar> bottom_radius, top_radius, height;
};

// Index into Scene::meshes.
struct MeshId {
  std::uint32_t index = 0;
};

struct Sphere {};
struct Box {};
struct Square {};
struct Cylinder {};

struct Primitive {
  std::variant<Sphere, Box, Square, Cylinder, Cone, MeshId> shape;
  std::vector<Material> materials;  // each `material =` in order; the last one counts
  std::optional<Name> name;
};

struct Group {};
struct Translate {
  std::array<double, 3> offset{};
};
struct Rotate {
  std::array<double, 3> axis{};
  double angle = 0;  // radians, right-handed
};
struct Scale {
  std::array<double, 3> factors{};
};
struct Transform {
  std::array<std::array<double, 4>, 4> rows{};
};

using ElementId = std::uint32_t;
inline constexpr ElementId no_element = 0xffffffffu;

// A primitive, a transform (one child), a group (any number), or a `material =` inside a group, which is the
// default for what follows it up to the group's end.
struct Element {
  std::variant<Primitive, Group, Translate, Rotate, Scale, Transform, Material> what;
  Span span;
  Span keyword;                        // the word (or brace) it begins with
  ElementId first_child = no_element;  // of groups and transforms
  ElementId next_sibling = no_element;
};

// --- the scene ---------------------------------------------------------------------------------------------

// What stands at the top level, in file order. An ElementId is the root of a tree in `elements`.
using Item = std::variant<Camera, AmbientLight, DirectionalLight, PointLight, Material, ElementId>;

struct Scene {
  double version = 0;
  std::vector<Item> items;
  std::vector<Element> elements;
  std::vector<Mesh> meshes;
};

}  // namespace trace::parser
