#include "parser/vocabulary.hpp"

#include <algorithm>
#include <array>

#include "parser/dialect_words.hpp"

namespace trace::parser {

namespace {

struct Entry {
  std::string_view word;
  Kind kind;
};

// In alphabetical order: it is searched by halving. The first of two synonyms is the usual one.
constexpr std::array words{
    Entry{"SBT-raytracer", T::HEADER},
    Entry{"ambient", T::AMBIENT},
    Entry{"ambient_light", T::AMBIENT_LIGHT},
    Entry{"aspectratio", T::ASPECTRATIO},
    Entry{"bottom_radius", T::BOTTOM_RADIUS},
    Entry{"box", T::BOX},
    Entry{"camera", T::CAMERA},
    Entry{"capped", T::CAPPED},
    Entry{"color", T::COLOR},
    Entry{"colour", T::COLOR},
    Entry{"cone", T::CONE},
    Entry{"constant_attenuation_coeff", T::CONSTANT},
    Entry{"cylinder", T::CYLINDER},
    Entry{"diffuse", T::DIFFUSE},
    Entry{"direction", T::DIRECTION},
    Entry{"directional_light", T::DIRECTIONAL_LIGHT},
    Entry{"emissive", T::EMISSIVE},
    Entry{"faces", T::FACES},
    Entry{"false", T::FALSE},
    Entry{"fov", T::FOV},
    Entry{"gennormals", T::GENNORMALS},
    Entry{"height", T::HEIGHT},
    Entry{"index", T::INDEX},
    Entry{"linear_attenuation_coeff", T::LINEAR},
    Entry{"map", T::MAP},
    Entry{"material", T::MATERIAL},
    Entry{"materials", T::MATERIALS},
    Entry{"name", T::NAME},
    Entry{"normals", T::NORMALS},
    Entry{"point_light", T::POINT_LIGHT},
    Entry{"points", T::POINTS},
    Entry{"polymesh", T::MESH},
    Entry{"position", T::POSITION},
    Entry{"quadratic_attenuation_coeff", T::QUADRATIC},
    Entry{"quaternian", T::QUATERNIAN},
    Entry{"reflective", T::REFLECTIVE},
    Entry{"rotate", T::ROTATE},
    Entry{"scale", T::SCALE},
    Entry{"shininess", T::SHININESS},
    Entry{"specular", T::SPECULAR},
    Entry{"sphere", T::SPHERE},
    Entry{"square", T::SQUARE},
    Entry{"top_radius", T::TOP_RADIUS},
    Entry{"transform", T::TRANSFORM},
    Entry{"translate", T::TRANSLATE},
    Entry{"transmissive", T::TRANSMISSIVE},
    Entry{"trimesh", T::MESH},
    Entry{"true", T::TRUE},
    Entry{"updir", T::UPDIR},
    Entry{"viewdir", T::VIEWDIR},
};
static_assert(std::is_sorted(words.begin(), words.end(),
                             [](const Entry& a, const Entry& b) { return a.word < b.word; }));

constexpr std::array punctuation{
    Entry{"{", T::OPEN_BRACE},  Entry{"}", T::CLOSE_BRACE}, Entry{"(", T::OPEN_PAREN},
    Entry{")", T::CLOSE_PAREN}, Entry{",", T::COMMA},       Entry{"=", T::EQUALS},
    Entry{";", T::SEMICOLON},
};

using Kinds = std::vector<Kind>;

const Kinds camera{T::POSITION, T::VIEWDIR, T::UPDIR, T::FOV, T::ASPECTRATIO, T::QUATERNIAN, T::HEIGHT};
const Kinds ambient_light{T::COLOR};
const Kinds directional_light{T::DIRECTION, T::COLOR};
const Kinds point_light{T::POSITION, T::COLOR, T::CONSTANT, T::LINEAR, T::QUADRATIC};
const Kinds directed{T::POSITION, T::DIRECTION, T::COLOR, T::CONSTANT, T::LINEAR, T::QUADRATIC};
const Kinds rectangle{T::POSITION, T::DIRECTION, T::UPDIR,  T::COLOR,
                      T::HEIGHT,   T::CONSTANT,  T::LINEAR, T::QUADRATIC};
const Kinds disc{T::POSITION, T::COLOR, T::BOTTOM_RADIUS, T::CONSTANT, T::LINEAR, T::QUADRATIC};
const Kinds color{T::COLOR};
const Kinds solid{T::SCALE, T::COLOR};
const Kinds noise{T::SCALE};
const Kinds material{T::EMISSIVE,     T::AMBIENT,   T::DIFFUSE, T::SPECULAR, T::REFLECTIVE,
                     T::TRANSMISSIVE, T::SHININESS, T::INDEX,   T::NAME};
const Kinds shape{T::MATERIAL, T::NAME};
const Kinds cylinder{T::MATERIAL, T::NAME, T::CAPPED};
const Kinds quadric{T::MATERIAL, T::NAME, T::POINTS};
const Kinds height_field{T::MATERIAL, T::NAME, T::GENNORMALS};
const Kinds cone{T::MATERIAL, T::NAME, T::CAPPED, T::BOTTOM_RADIUS, T::TOP_RADIUS, T::HEIGHT};
const Kinds mesh{T::MATERIAL, T::NAME, T::POINTS, T::FACES, T::NORMALS, T::MATERIALS, T::GENNORMALS};
const Kinds group{T::SPHERE,    T::BOX,    T::SQUARE, T::CYLINDER,  T::CONE,    T::MESH,
                  T::TRANSLATE, T::ROTATE, T::SCALE,  T::TRANSFORM, T::MATERIAL};
const Kinds scene{
    T::SPHERE,       T::BOX,   T::SQUARE,    T::CYLINDER, T::CONE,   T::MESH,        T::TRANSLATE,
    T::ROTATE,       T::SCALE, T::TRANSFORM, T::MATERIAL, T::CAMERA, T::POINT_LIGHT, T::DIRECTIONAL_LIGHT,
    T::AMBIENT_LIGHT};
const Kinds nothing;

}  // namespace

std::optional<Kind> reserved_word(std::string_view word) {
  const auto found = std::lower_bound(words.begin(), words.end(), word,
                                      [](const Entry& entry, std::string_view w) { return entry.word < w; });
  if (found == words.end() || found->word != word) return std::nullopt;
  return found->kind;
}

bool is_reserved(std::string_view word) {
  return reserved_word(word).has_value();
}

bool is_keyword(Kind kind) {
  return kind >= T::HEADER;
}

std::string_view spelling(Kind kind) {
  if (kind == T::MESH) return "trimesh";
  for (const Entry& entry : words) {
    if (entry.kind == kind) return entry.word;
  }
  for (const Entry& entry : punctuation) {
    if (entry.kind == kind) return entry.word;
  }
  return "";
}

bool is_primitive(Kind kind) {
  return begins_statement(T::OPEN_BRACE, kind) && !is_transform(kind) && kind != T::MATERIAL;
}

bool is_transform(Kind kind) {
  return kind == T::TRANSLATE || kind == T::ROTATE || kind == T::SCALE || kind == T::TRANSFORM;
}

bool is_light(Kind kind) {
  switch (kind) {
    case T::POINT_LIGHT:
    case T::DIRECTIONAL_LIGHT:
    case T::AMBIENT_LIGHT:
    case T::SPOT_LIGHT:
    case T::AREA_LIGHT:
    case T::AREA_LIGHT_RECT:
    case T::AREA_LIGHT_CIRC:
    case T::SHAPE_LIGHT:
    case T::WARN_LIGHT:
    case T::WARN_MODEL_LIGHT:
      return true;
    default:
      return false;
  }
}

const std::vector<Kind>& statements_of(Kind block) {
  switch (block) {
    case T::CAMERA:
      return camera;
    case T::AMBIENT_LIGHT:
      return ambient_light;
    case T::DIRECTIONAL_LIGHT:
      return directional_light;
    case T::POINT_LIGHT:
      return point_light;
    case T::MATERIAL:
      return material;
    case T::SPOT_LIGHT:
    case T::AREA_LIGHT_CIRC:
    case T::SHAPE_LIGHT:
    case T::WARN_LIGHT:
    case T::WARN_MODEL_LIGHT:
      return directed;
    case T::AREA_LIGHT:
      return disc;
    case T::AREA_LIGHT_RECT:
      return rectangle;
    case T::FOG:
      return color;
    case T::MARBLE:
      return solid;
    case T::PERLIN_NOISE:
      return noise;
    case T::SPHERE:
    case T::BOX:
    case T::SQUARE:
    case T::PLANE:
    case T::TORUS:
    case T::PARABOLOID:
    case T::HYPERBOLOID:
    case T::HYPERBOLIC:
    case T::HYPERBOLIC_PARABOLOID:
    case T::TORUS_KNOT:
      return shape;
    case T::CYLINDER:
      return cylinder;
    case T::QUADRIC:
      return quadric;
    case T::HEIGHT_FIELD:
      return height_field;
    case T::CONE:
      return cone;
    case T::MESH:
      return mesh;
    case T::OPEN_BRACE:
      return group;
    case T::END:
      return scene;
    default:
      return nothing;
  }
}

bool begins_statement(Kind block, Kind word) {
  const std::vector<Kind>& core = statements_of(block);
  if (std::find(core.begin(), core.end(), word) != core.end()) return true;
  const std::vector<DialectWord>& more = dialect_words(block);
  return std::any_of(more.begin(), more.end(), [word](const DialectWord& w) { return w.kind == word; });
}

std::vector<std::string_view> statement_words(Kind block) {
  std::vector<std::string_view> result;
  for (const Kind kind : statements_of(block)) {
    for (const Entry& entry : words) {
      if (entry.kind == kind) result.push_back(entry.word);
    }
  }
  for (const DialectWord& word : dialect_words(block)) result.push_back(word.word);
  return result;
}

std::vector<std::string_view> usual_words(Kind block) {
  std::vector<std::string_view> result;
  for (const Kind kind : statements_of(block)) result.push_back(spelling(kind));
  for (const DialectWord& word : dialect_words(block)) {
    if (word.usual) result.push_back(word.word);
  }
  return result;
}

}  // namespace trace::parser
