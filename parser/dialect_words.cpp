#include "parser/dialect_words.hpp"

#include <algorithm>

#include "parser/vocabulary.hpp"

namespace trace::parser {

namespace {

using Words = std::vector<DialectWord>;

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Attributes whose values tell them apart are one kind of token: the grammar hands their word on.
Words attributes(Kind kind, std::initializer_list<std::string_view> usual,
                 std::initializer_list<std::string_view> others = {}) {
  Words result;
  for (const std::string_view word : usual) result.push_back({word, kind, true});
  for (const std::string_view word : others) result.push_back({word, kind, false});
  return result;
}

// Of the blocks.
namespace added {

const Words camera{{"look_at", T::LOOK_AT},
                   {"projection", T::PROJECTION},
                   {"quaternion", T::QUATERNIAN, false},
                   {"focaldistance", T::WITHOUT_EFFECT, false}};

const Words point_light = attributes(T::WITHOUT_EFFECT, {}, {"angle", "central_direction"});
const Words spot_light =
    attributes(T::LIGHT_ATTRIBUTE, {"target", "angle", "inner_angle", "exponent"},
               {"atten_angle",      "beamDistribution", "blend",           "central_direction",
                "coneAngle",        "cone_angle",       "coneangle",       "coneboundary",
                "coneDeltaAngle",   "conedirection",    "cutoff_distance", "cut_off_angle",
                "drop_off_rate",    "edgeplace",        "fall_rate",       "focus_constraint",
                "intensity_factor", "penumbra",         "radius",          "size",
                "specular_exponent"});
const Words area_light = attributes(T::LIGHT_ATTRIBUTE, {"u", "v", "radius"}, {"area", "light_radius"});
const Words area_light_rect = attributes(T::LIGHT_ATTRIBUTE, {"width"});
const Words area_light_circ = attributes(T::LIGHT_ATTRIBUTE, {"radius"});
const Words shape_light = attributes(T::LIGHT_ATTRIBUTE, {"shape", "parms", "up"}, {"type"});
const Words warn_light =
    attributes(T::LIGHT_ATTRIBUTE, {"exponent", "xmin", "xmax", "ymin", "ymax", "zmin", "zmax"},
               {"coneAngle", "cutoff_distance", "edgeplace", "flap_0", "flap_1", "normal", "p",
                "radius",    "shape",           "size",      "type",   "x_max",  "x_min",  "xflap",
                "y_max",     "y_min",           "yflap",     "z_max",  "z_min",  "zflap"});
const Words warn_model_light = attributes(
    T::LIGHT_ATTRIBUTE, {"central_direction", "specular_exponent"},
    {"shape", "size", "type", "xflapmax", "xflapmin", "yflapmax", "yflapmin", "zflapmax", "zflapmin"});

const Words fog{{"start", T::FOG_START}, {"end", T::FOG_END}, {"density", T::DENSITY}, {"axis", T::AXIS}};
const Words cubemap =
    attributes(T::FACE, {"posx", "negx", "posy", "negy", "posz", "negz"}) + Words{{"file", T::FILE_NAME}};
const Words skybox = attributes(T::FACE, {"right", "left", "top", "bottom", "front", "back"});

const Words material{{"absorb", T::ABSORB},
                     {"glossiness", T::GLOSSINESS},
                     {"specular_model", T::SPECULAR_MODEL},
                     {"bump", T::BUMP},
                     {"normal", T::NORMAL_MAP},
                     {"anisotropic_specular", T::ANISOTROPIC_SPECULAR, false},
                     {"bump_map", T::BUMP, false},
                     {"bump_mapping", T::BUMP, false},
                     {"diffuse_map", T::DIFFUSE_MAP, false},
                     {"normal_map", T::NORMAL_MAP, false},
                     {"specular_map", T::SPECULAR_MAP, false},
                     {"texture", T::DIFFUSE_MAP, false}};

// Maps beside the material of a primitive.
const Words shape{{"diffuse_map", T::DIFFUSE_MAP, false},
                  {"specular_map", T::SPECULAR_MAP, false},
                  {"bump_map", T::BUMP, false},
                  {"normal_map", T::NORMAL_MAP, false},
                  {"anisotropic_specular", T::ANISOTROPIC_SPECULAR, false},
                  {"perlin_noise", T::PERLIN_NOISE, false}};
const Words plane = Words{{"point", T::POINT}, {"normal", T::NORMAL}} + shape;
const Words torus = Words{{"major_radius", T::MAJOR_RADIUS},  {"minor_radius", T::MINOR_RADIUS},
                          {"a", T::MAJOR_RADIUS, false},      {"b", T::MINOR_RADIUS, false},
                          {"radius", T::MAJOR_RADIUS, false}, {"ring_radius", T::MINOR_RADIUS, false}} +
                    shape;
const Words quadric = Words{{"coefficients", T::COEFFICIENTS}} + shape;
const Words paraboloid = Words{{"A", T::FACTOR_A},
                               {"B", T::FACTOR_B},
                               {"lower_bound", T::LOWER_BOUND},
                               {"upper_bound", T::UPPER_BOUND}} +
                         shape;
const Words hyperboloid = Words{{"type_x", T::TYPE_X}} + shape;
const Words torus_knot =
    Words{{"radius", T::RADIUS}, {"tube", T::TUBE}, {"p", T::KNOT_P}, {"q", T::KNOT_Q}} + shape;
const Words height_field = Words{{"height_map", T::HEIGHT_MAP}, {"color_map", T::COLOR_MAP}} + shape;
const Words mesh =
    Words{{"texture_uv", T::TEXTURE_UV}, {"map_points", T::TEXTURE_UV, false}, {"objfile", T::OBJFILE}} +
    shape;

const Words marble{
    {"lightness", T::LIGHTNESS}, {"contrast", T::CONTRAST}, {"frequency", T::FREQUENCY}, {"depth", T::DEPTH}};
const Words perlin_noise{{"frequency", T::FREQUENCY}, {"turbulence_depth", T::DEPTH}};

const Words group{{"plane", T::PLANE},
                  {"torus", T::TORUS},
                  {"quadric", T::QUADRIC},
                  {"paraboloid", T::PARABOLOID},
                  {"hyperboloid", T::HYPERBOLOID},
                  {"hyperbolic_paraboloid", T::HYPERBOLIC_PARABOLOID},
                  {"torus_knot", T::TORUS_KNOT},
                  {"height_field", T::HEIGHT_FIELD},
                  {"hyperbolic", T::HYPERBOLIC, false}};
const Words scene = group + Words{{"spot_light", T::SPOT_LIGHT},
                                  {"area_light", T::AREA_LIGHT},
                                  {"area_light_rect", T::AREA_LIGHT_RECT},
                                  {"area_light_circ", T::AREA_LIGHT_CIRC},
                                  {"shape_light", T::SHAPE_LIGHT},
                                  {"warn_light", T::WARN_LIGHT},
                                  {"warn_model_light", T::WARN_MODEL_LIGHT},
                                  {"warn_model", T::WARN_MODEL_LIGHT, false},
                                  {"fog", T::FOG},
                                  {"cubemap", T::CUBEMAP},
                                  {"skybox", T::SKYBOX}};
const Words nothing;

}  // namespace added

}  // namespace

const std::vector<DialectWord>& dialect_words(Kind block) {
  switch (block) {
    case T::CAMERA:
      return added::camera;
    case T::POINT_LIGHT:
      return added::point_light;
    case T::SPOT_LIGHT:
      return added::spot_light;
    case T::AREA_LIGHT:
      return added::area_light;
    case T::AREA_LIGHT_RECT:
      return added::area_light_rect;
    case T::AREA_LIGHT_CIRC:
      return added::area_light_circ;
    case T::SHAPE_LIGHT:
      return added::shape_light;
    case T::WARN_LIGHT:
      return added::warn_light;
    case T::WARN_MODEL_LIGHT:
      return added::warn_model_light;
    case T::FOG:
      return added::fog;
    case T::CUBEMAP:
      return added::cubemap;
    case T::SKYBOX:
      return added::skybox;
    case T::MATERIAL:
      return added::material;
    case T::SPHERE:
    case T::BOX:
    case T::SQUARE:
    case T::CYLINDER:
    case T::CONE:
    case T::HYPERBOLIC:
    case T::HYPERBOLIC_PARABOLOID:
      return added::shape;
    case T::PLANE:
      return added::plane;
    case T::TORUS:
      return added::torus;
    case T::QUADRIC:
      return added::quadric;
    case T::PARABOLOID:
      return added::paraboloid;
    case T::HYPERBOLOID:
      return added::hyperboloid;
    case T::TORUS_KNOT:
      return added::torus_knot;
    case T::HEIGHT_FIELD:
      return added::height_field;
    case T::MESH:
      return added::mesh;
    case T::MARBLE:
      return added::marble;
    case T::PERLIN_NOISE:
      return added::perlin_noise;
    case T::OPEN_BRACE:
      return added::group;
    case T::END:
      return added::scene;
    default:
      return added::nothing;
  }
}

const DialectWord* find_dialect_word(Kind block, std::string_view word) {
  const std::vector<DialectWord>& words = dialect_words(block);
  const auto found =
      std::find_if(words.begin(), words.end(), [word](const DialectWord& w) { return w.word == word; });
  return found == words.end() ? nullptr : &*found;
}

std::optional<Kind> dialect_word(Kind block, std::string_view word) {
  const DialectWord* const found = find_dialect_word(block, word);
  return found == nullptr ? std::nullopt : std::optional(found->kind);
}

}  // namespace trace::parser
