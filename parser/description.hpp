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
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "parser/source.hpp"

namespace trace::parser {

// A value that is held apart, so that what may have one stays small: there may be a hundred thousand
// materials. Copies share it.
template <class T>
class Apart {
 public:
  Apart(T value) : value_(std::make_shared<const T>(std::move(value))) {}
  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }

 private:
  std::shared_ptr<const T> value_;
};

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
  transmissive,
  absorb,  // colours, up to here
  index,
  shininess,
  glossiness,      // numbers, up to here
  bump,            // a map of heights
  normal,          // a map of normals
  anisotropy,      // a map of highlights along a cylinder (anisotropic_specular)
  specular_model,  // a word: "phong" or "blinn-phong"
};

// map("file"), or the bare string "file".
struct MapFile {
  std::string file;   // as written, but with '/' for each '\\' where there is no '/'
  bool bare = false;  // without map( )
  // map("file", "over", threshold): the second picture is laid over the first where it is brighter.
  std::string over{};  // empty: none
  double threshold = 0;
};

// marble { ... } and perlin_noise = { ... }: a colour that is computed at each point of space.
struct SolidTexture {
  enum class Kind : std::uint8_t { marble, perlin_noise };
  Kind kind{};
  std::optional<Vector3> color;  // marble
  std::optional<Scalar> lightness, contrast, frequency;
  std::optional<Vector3> scale;  // one number counts for all three
  std::optional<Scalar> depth;   // also turbulence_depth
};

// One `parameter = value` of a material. `value` is a number for the numbers, three for the colours, a word
// for specular_model, or the file of a map; colours may be solid textures.
struct MaterialAssignment {
  Parameter parameter{};
  std::variant<double, std::array<double, 3>, Apart<MapFile>, Apart<SolidTexture>, std::string> value;
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
// viewdir and updir are both given or both absent; look_at may stand without updir, and not beside viewdir.
struct Camera {
  std::optional<Vector3> position, viewdir, updir, look_at;
  std::optional<Scalar> fov, aspectratio;
  std::optional<Located<bool>> orthographic;  // projection =
  std::optional<Scalar> height;               // of what an orthographic camera sees
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

// The lights of the dialects: what they are called, and their attributes as they are written, each once. What
// they mean, and which go together, is worked out in src/scene/dialect_lights.hpp.
struct DialectLight {
  enum class Kind : std::uint8_t { spot, area, area_rectangle, area_disc, shape, warn, warn_model };
  struct Attribute {
    std::string_view word;  // of the table in parser/vocabulary.cpp: "cone_angle", "edgeplace"
    std::variant<double, std::array<double, 3>> value;
    Span span;        // of the word
    Span value_span;  // of the value
  };
  Kind kind{};
  std::string_view word;  // "spot_light"
  std::vector<Attribute> attributes;
  Span keyword, span;

  const Attribute* find(std::string_view name) const {
    for (const Attribute& attribute : attributes) {
      if (attribute.word == name) return &attribute;
    }
    return nullptr;
  }
};

// --- surroundings ------------------------------------------------------------------------------------------

// cubemap { ... } and skybox { ... }: six faces, or one file of a set as the option -c takes it. In the order
// +x -x +y -y, and of z the face seen along -z, then the one seen along +z, as CubeMap has them
// (src/scene/cube_map.hpp). Of a skybox: right left top bottom front back.
struct Surroundings {
  bool skybox = false;
  std::array<std::optional<Name>, 6> faces;
  std::optional<Name> file;
  Span keyword, span;
};

// fog { ... }
struct Fog {
  std::optional<Vector3> color, axis;
  std::optional<Scalar> start, end, density;
  Span keyword, span;
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
// has at least three corners; normals, texture coordinates and materials are as many as the points or none.
// With `file` there are no lists.
struct Mesh {
  std::vector<double> points;             // 3 numbers a point
  std::vector<double> normals;            // 3 numbers a normal
  std::vector<std::uint32_t> corners;     // indices into points, face after face
  std::vector<std::uint32_t> face_sizes;  // corners of each face; empty when every face is a triangle
  VertexMaterials vertex_materials;
  std::vector<double> texture_coordinates;  // 2 numbers a point: texture_uv, map_points
  bool generate_normals = false;
  std::optional<Name> file;  // objfile: an OBJ file that says the rest

  std::vector<ListSpan> point_lists, normal_lists, face_lists, coordinate_lists;
  std::vector<MaterialList> material_lists;

  bool has_no_lists() const {
    return point_lists.empty() && normal_lists.empty() && face_lists.empty() && coordinate_lists.empty() &&
           material_lists.empty();
  }
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
struct Cylinder {
  std::optional<Located<bool>> capped;
};

// Without an end: through `point` (the origin), its front towards `normal` (+z).
struct Plane {
  std::optional<Vector3> point, normal;
};

// About the z axis. major_radius, minor_radius; also radius and ring_radius, and a and b.
struct Torus {
  std::optional<Scalar> major_radius, minor_radius;
};

// quadric, paraboloid, hyperboloid, hyperbolic and hyperbolic_paraboloid.
struct Quadric {
  enum class Kind : std::uint8_t { general, paraboloid, hyperboloid, hyperbolic, hyperbolic_paraboloid };
  Kind kind{};
  // Of a general one, as they are written: `coefficients = (...)`, or rows of any length, `points = ((...),
  // ...)`.
  std::vector<double> coefficients;
  std::optional<Span> coefficients_span;
  std::optional<Scalar> a, b, lower_bound, upper_bound;  // of a paraboloid
  std::optional<Scalar> type_x;                          // of a hyperboloid
};

// A tube around a knot.
struct TorusKnot {
  std::optional<Scalar> radius, tube, p, q;
};

// A picture of heights over the unit square.
struct HeightField {
  std::optional<Name> height_map, color_map;
  bool generate_normals = false;
};

struct Primitive {
  std::variant<Sphere, Box, Square, Cylinder, Cone, MeshId, Plane, Torus, Quadric, TorusKnot, HeightField>
      shape;
  std::vector<Material> materials;  // each `material =` in order; the last one counts
  std::optional<Name> name;
  // Maps given beside the material, not in it (diffuse_map, bump_map, ...): they apply on top of it.
  std::vector<MaterialAssignment> maps{};
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
using Item = std::variant<Camera, AmbientLight, DirectionalLight, PointLight, DialectLight, Surroundings, Fog,
                          Material, ElementId>;

// Families of the language whose meaning differs (docs/language.md section 14).
enum class Dialect : std::uint8_t { utexas, uw, hkust };

struct Scene {
  double version = 0;
  Dialect dialect = Dialect::utexas;
  bool permissive = false;  // files that cannot be read are left out, too
  std::vector<Item> items;
  std::vector<Element> elements;
  std::vector<Mesh> meshes;
};

}  // namespace trace::parser
