#include "scene/dialect_lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "geometry/unit_vector.hpp"
#include "scene/light_attributes.hpp"

namespace trace {
namespace {

using Attribute = LightAttributes::Attribute;
using Kind = parser::DialectLight::Kind;

const LightAttributes::Words direction_words{"direction", "central_direction", "conedirection", "normal"};
const LightAttributes::Words exponent_words{
    "exponent", "specular_exponent", "focus_constraint", "beamDistribution", "drop_off_rate", "fall_rate",
    "p"};
const LightAttributes::Words cone_words{"angle",     "cone_angle",    "coneangle",
                                        "coneAngle", "cut_off_angle", "atten_angle"};

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}
double cosine_of_degrees(double degrees) {
  return std::cos(radians(degrees));
}

// Two vectors of unit length, at right angles to `axis` and to each other, the second as near to `up` as can
// be. Along `up` the x axis takes its place.
struct Across {
  Vec3 x, up;
};
Across across(const Vec3& axis, const Vec3& up) {
  for (const Vec3& hint : {up, Vec3(1, 0, 0)}) {
    const Vec3 x = glm::cross(axis, hint);
    // Less than 2^-26 is what roundings leave of vectors along one line.
    if (glm::length(x) > 0x1p-26 * glm::length(hint)) {
      const Vec3 unit = glm::normalize(x);
      return {unit, glm::cross(unit, axis)};
    }
  }
  return {Vec3(0, 0, 1), glm::cross(Vec3(0, 0, 1), axis)};  // `up` is the x axis, and so is `axis`
}

class Reader {
 public:
  Reader(const parser::DialectLight& light, parser::Diagnostics& diagnostics)
      : kind_(light.kind), said_(light, diagnostics) {}

  std::optional<Light> read() {
    if (const auto position = said_.vector(said_.needed({"position"}))) position_ = *position;
    if (const auto color = said_.vector(said_.needed({"color", "colour"}))) color_ = *color;
    const auto coefficient = [this](std::string_view word) {
      return static_cast<float>(said_.number(said_.one_of({word})).value_or(0));
    };
    constant_ = coefficient("constant_attenuation_coeff");
    linear_ = coefficient("linear_attenuation_coeff");
    quadratic_ = coefficient("quadratic_attenuation_coeff");
    Light result = light();
    if (!said_.good()) return std::nullopt;
    said_.warn_of_unused();
    return result;
  }

 private:
  Light light() {
    switch (kind_) {
      case Kind::spot:
        return spot();
      case Kind::area:
        return area();
      case Kind::area_rectangle:
        return rectangle();
      case Kind::area_disc:
        return disc();
      case Kind::shape:
        return shape();
      case Kind::warn:
      case Kind::warn_model:
        break;
    }
    return warn();
  }

  Light limited() const { return SpotLight{color_, position_, constant_, linear_, quadratic_, beam_}; }
  Light extended(AreaLight::Extent extent, const Vec3& position, const Vec3& u, const Vec3& v) const {
    return AreaLight{color_, extent, position, u, v, constant_, linear_, quadratic_, beam_};
  }

  // --- spot lights ---

  Light spot() {
    aim();
    cone();
    const bool powered = exponent();
    if (!has_cone_ && !powered && said_.good()) said_.missing("'angle'");
    reach();
    if (const auto factor = said_.number(said_.one_of({"intensity_factor"}))) color_ *= *factor;
    const auto radius = said_.not_negative(said_.one_of({"radius"}));
    if (!radius || *radius == 0) return limited();
    const Across axes = across(beam_.direction, Vec3(0, 1, 0));
    return extended(AreaLight::Extent::disc, position_, *radius * axes.x, *radius * axes.up);
  }

  // From one of the words for a direction, or from a target.
  void aim() {
    const Attribute* target = said_.one_of({"target"});
    if (!target && !said_.has_any(direction_words)) return said_.missing("'direction' or 'target'");
    const Attribute* direction = said_.one_of(direction_words);
    if (target && direction) return said_.error(*target, fmt::format("stands beside '{}'", direction->word));
    if (!target) {
      if (const auto unit = said_.direction(direction)) beam_.direction = *unit;
      return;
    }
    if (const auto point = said_.vector(target)) {
      if (*point == position_) return said_.error(*target, "is the position of the light");
      beam_.direction = unit_vector(*point - position_).direction;
    }
  }

  std::optional<double> angle(const Attribute* attribute, bool from_edge_to_edge = false) {
    const auto value = said_.leading_number(attribute);
    if (!value) return std::nullopt;
    if (!(*value > 0 && *value <= (from_edge_to_edge ? 360 : 180))) {
      said_.error(*attribute, fmt::format("must be greater than 0 and at most {} degrees",
                                          from_edge_to_edge ? 360 : 180));
      return std::nullopt;
    }
    if (*value <= std::numbers::pi / 2) {
      said_.warning(*attribute,
                    fmt::format("'{0}' is in degrees: {1} is a very narrow beam; {1} radians would "
                                "be {2:.6g}",
                                attribute->word, *value, *value * 180 / std::numbers::pi));
    }
    return from_edge_to_edge ? *value / 2 : *value;
  }

  // The cone of a spot light, in any of the ways to say it; Warn's lights have some of them.
  void cone() {
    const bool is_spot = kind_ == Kind::spot;
    const Attribute* outer =
        is_spot ? said_.one_of({"angle", "cone_angle", "coneangle", "coneAngle", "cut_off_angle",
                                "atten_angle", "edgeplace", "size", "coneboundary"})
                : said_.one_of({"angle", "cone_angle", "coneangle", "coneAngle", "cut_off_angle",
                                "atten_angle", "edgeplace"});
    if (!outer) return;
    has_cone_ = true;
    double cosine = -1;
    std::optional<double> degrees;
    if (outer->word == "coneboundary") {
      const auto boundary = said_.direction(outer);
      if (!boundary) return;
      cosine = glm::dot(*boundary, beam_.direction);
      degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    } else {
      degrees = angle(outer, outer->word == "size");
      if (!degrees) return;
      cosine = cosine_of_degrees(*degrees);
    }
    beam_.cosine_of_edge = beam_.cosine_of_full = cosine;
    const Attribute* inner = said_.one_of({"inner_angle", "penumbra", "coneDeltaAngle", "blend"});
    const auto value = said_.not_negative(inner);
    if (!value) return;
    if (inner->word == "blend") {
      if (*value > 1) return said_.error(*inner, "must be at most 1");
      beam_.cosine_of_full = cosine + (1 - cosine) * *value;
      return;
    }
    if (*value > *degrees) return said_.error(*inner, fmt::format("must not exceed '{}'", outer->word));
    beam_.cosine_of_full = cosine_of_degrees(inner->word == "coneDeltaAngle" ? *degrees - *value : *value);
  }

  bool exponent() {
    const auto value = said_.not_negative(said_.one_of(exponent_words));
    if (value) beam_.exponent = *value;
    return value.has_value();
  }

  void reach() {
    if (const auto value = said_.positive(said_.one_of({"cutoff_distance"}))) beam_.reach = *value;
  }

  // --- lights with a size ---

  Light area() {
    const Attribute* size = said_.one_of({"bottom_radius", "light_radius", "radius", "area", "u"});
    if (!size) {
      if (said_.good()) {
        said_.missing("size: 'u' and 'v', 'radius', 'bottom_radius', 'light_radius' or 'area'");
      }
      return limited();
    }
    if (size->word == "u") {
      const auto u = said_.vector(size), v = said_.vector(said_.needed({"v"}));
      return u && v ? extended(AreaLight::Extent::parallelogram, position_, *u, *v) : limited();
    }
    const double length = said_.not_negative(size).value_or(0);
    const Vec3 x(length, 0, 0), z(0, 0, length);
    if (size->word == "area") {
      return extended(AreaLight::Extent::parallelogram, position_ - (x + z) / 2.0, x, z);
    }
    if (size->word == "bottom_radius") return extended(AreaLight::Extent::disc, position_, x, z);
    return extended(AreaLight::Extent::ball, position_, x, Vec3(0));
  }

  // Shines to the side that its direction points to.
  void face() {
    if (const auto unit = said_.direction(said_.needed({"direction"}))) beam_.direction = *unit;
    beam_.cosine_of_edge = beam_.cosine_of_full = 0;
  }

  Light rectangle() {
    face();
    const auto up = said_.direction(said_.one_of({"updir"}));
    const auto width = said_.not_negative(said_.needed({"width"})),
               height = said_.not_negative(said_.needed({"height"}));
    if (!said_.good()) return limited();
    const Across axes = across(beam_.direction, up.value_or(Vec3(0, 1, 0)));
    const Vec3 u = *width * axes.x, v = *height * axes.up;
    return extended(AreaLight::Extent::parallelogram, position_ - 0.5 * u - 0.5 * v, u, v);
  }

  Light disc() {
    face();
    const auto radius = said_.not_negative(said_.needed({"radius"}));
    if (!said_.good()) return limited();
    const Across axes = across(beam_.direction, Vec3(0, 1, 0));
    return extended(AreaLight::Extent::disc, position_, *radius * axes.x, *radius * axes.up);
  }

  // --- beams with a shape ---

  // A number from `first` on that stands for one of as many things as `names` says.
  std::optional<int> choice(const Attribute* attribute, int first, int count, std::string_view names) {
    const auto value = said_.leading_number(attribute);
    if (!value) return std::nullopt;
    for (int k = first; k < first + count; ++k) {
      if (*value == k) return k;
    }
    said_.error(*attribute, fmt::format("is {}", names));
    return std::nullopt;
  }

  Light shape() {
    aim();
    const auto up = said_.direction(said_.one_of({"up"}));
    const Attribute* sizes = said_.needed({"parms"});
    const auto numbers = said_.vector(sizes);
    const auto outline =
        choice(said_.needed({"shape", "type"}), 0, 3, "0 (a triangle), 1 (a square) or 2 (a star)");
    if (!said_.good()) return limited();
    if (!(numbers->x > 0 && numbers->y > 0 && numbers->z >= 0)) {
      said_.error(*sizes, "takes a size and a distance above 0 and an exponent that is not negative");
      return limited();
    }
    const Across axes = across(beam_.direction, up.value_or(Vec3(0, 1, 0)));
    beam_.aperture = *outline == 1 ? Aperture::square(numbers->x, axes.x, axes.up)
                                   : Aperture(3, *outline == 2, numbers->x, axes.x, axes.up);
    beam_.aperture_distance = numbers->y;
    beam_.exponent = numbers->z;
    return limited();
  }

  // --- Warn's lights ---

  Light warn() {
    if (said_.has("radius")) return prism();
    const bool has_flaps = flaps();
    const bool needs_direction =
        !has_flaps || said_.has("size") || said_.has_any(exponent_words) || said_.has_any(cone_words);
    if (needs_direction || said_.has("target") || said_.has_any(direction_words)) aim();
    cone();
    // The project that has these two corners takes the eighth power.
    if (!exponent() && said_.has("flap_0")) beam_.exponent = 8;
    reach();
    if (said_.has("size")) aperture();
    return limited();
  }

  // A beam along the z axis, both ways, which does not spread; `direction` is by how many degrees its outline
  // is turned from +y towards +x.
  Light prism() {
    const auto radius = said_.leading_number(said_.one_of({"radius"}));
    const auto outline = choice(said_.needed({"type", "shape"}), 1, 4,
                                "1 (a triangle), 2 (a square), 3 (a hexagon) or 4 (a circle)");
    const auto turn = said_.leading_number(said_.one_of({"direction"}));
    if (!radius || !outline) return limited();
    const double angle = radians(turn.value_or(0));
    const Vec3 up(std::sin(angle), std::cos(angle), 0), x(up.y, -up.x, 0);
    constexpr int corners[] = {3, 4, 6, 0};
    beam_.direction = Vec3(0, 0, 1);
    beam_.aperture = Aperture(corners[*outline - 1], false, *radius, x, up);
    return limited();
  }

  // In front of the light at distance 1.
  void aperture() {
    const auto size = said_.positive(said_.one_of({"size"}));
    const auto outline = choice(said_.one_of({"type", "shape"}), 0, 4,
                                "0 (a square), 1 (a triangle), 2 (a star) or 3 (a circle)");
    if (!size || !said_.good()) return;
    const Across axes = across(beam_.direction, Vec3(0, 1, 0));
    const int which = outline.value_or(0);
    beam_.aperture = which == 0 ? Aperture::square(*size, axes.x, axes.up)
                                : Aperture(which == 3 ? 0 : 3, which == 2, *size, axes.x, axes.up);
    beam_.aperture_distance = 1;
  }

  // Whether there are any.
  bool flaps() {
    if (said_.has_any({"flap_0", "flap_1"})) {
      const auto low = said_.vector(said_.needed({"flap_0"})), high = said_.vector(said_.needed({"flap_1"}));
      const auto outline =
          choice(said_.one_of({"shape", "type"}), 0, 3, "0 (a box), 1 (half of it) or 2 (a circle)");
      if (!low || !high) return true;
      if (!glm::all(glm::lessThanEqual(*low, *high))) {
        said_.error(*said_.one_of({"flap_1"}), "must not be below 'flap_0' in any coordinate");
      }
      beam_.flaps = Flaps{*low, *high, static_cast<Flaps::Outline>(outline.value_or(0))};
      return true;
    }
    Flaps box;
    bool any = false;
    for (int axis = 0; axis < 3; ++axis) {
      const auto& words = flap_words[axis];
      const Attribute* high = said_.one_of({words[3], words[4], words[5]});
      const auto low_edge = said_.number(said_.one_of({words[0], words[1], words[2]})),
                 high_edge = said_.number(high), both = said_.not_negative(said_.one_of({words[6]}));
      any = any || low_edge || high_edge || both;
      if (both) {
        box.low[axis] = position_[axis] - *both;
        box.high[axis] = position_[axis] + *both;
      }
      if (low_edge) box.low[axis] = *low_edge;
      if (high_edge) box.high[axis] = *high_edge;
      if (low_edge && high_edge && *low_edge > *high_edge)
        said_.error(*high, "must not be below the other flap");
    }
    if (any) beam_.flaps = box;
    return any;
  }

  static constexpr std::string_view flap_words[3][7] = {
      {"xmin", "x_min", "xflapmin", "xmax", "x_max", "xflapmax", "xflap"},
      {"ymin", "y_min", "yflapmin", "ymax", "y_max", "yflapmax", "yflap"},
      {"zmin", "z_min", "zflapmin", "zmax", "z_max", "zflapmax", "zflap"}};

  Kind kind_;
  LightAttributes said_;
  Vec3 position_{0};
  Rgb color_{0};
  float constant_ = 0, linear_ = 0, quadratic_ = 0;
  Beam beam_;
  bool has_cone_ = false;
};

}  // namespace

std::optional<Light> make_light(const parser::DialectLight& light, parser::Diagnostics& diagnostics) {
  return Reader(light, diagnostics).read();
}

}  // namespace trace
