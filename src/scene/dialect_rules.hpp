// What the families of the language mean differently, in one place.
//
// utexas is what docs/language.md describes. The rules of `uw` were found by comparing with pictures that the
// UW course's sample solution drew (docs/results/uw-dialect.md tells which picture shows which). The HKUST
// course leaves shading to its students: there only what its file reader does to a scene is known.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "parser/description.hpp"

namespace trace {

struct DialectRules {
  // --- what a scene says (src/scene/) ---
  // A material that gives `specular` and not `reflective` mirrors with its specular colour.
  bool specular_reflects = false;
  // viewdir is made a unit vector and updir one at right angles to it; otherwise both are used as they are.
  bool orthonormal_camera = false;
  // Normals that `gennormals` makes are of unit length before they are interpolated.
  bool unit_generated_normals = false;
  // Cones are what they should be; otherwise they have the course's habits (geometry/cone.hpp).
  bool true_cones = false;
  // A map of w x h texels spans [0, 1] with w and h steps, not w - 1 and h - 1 (scene/texture.hpp).
  bool texels_have_width = false;

  // --- how light is computed (src/shading/) ---
  // Surfaces are shaded alike from both sides, with the normal turned to the viewer, and no mesh is culled.
  bool two_sided = false;
  // Highlights are (N.H)^shininess with H halfway between light and viewer (Blinn 1977), on the lit side
  // alone; otherwise (R.V)^shininess (Phong 1975).
  bool halfway_highlights = false;
  // Light is multiplied by kt where it passes a surface that transmits, whichever way; otherwise by kt to
  // the power of the way inside.
  bool transmission_at_surfaces = false;

  // The index of refraction outside of bodies.
  double index_of_air = 1;
  // What is met nearer than this to where a mirrored, refracted or shadow ray starts does not count, beside
  // what rounding alone can make of the start (shading/surface.hpp).
  double least_way = 0;

  // Whether light is computed by the rules of utexas, which are all that packets (shading/packet/) and
  // src/precision know. What a scene says is in the scene for them too, but for cones and textures.
  bool draws_as_utexas() const {
    return !true_cones && !texels_have_width && !two_sided && !halfway_highlights &&
           !transmission_at_surfaces && index_of_air == 1 && least_way == 0;
  }

  bool operator==(const DialectRules&) const = default;
};

constexpr DialectRules rules_of(parser::Dialect dialect) {
  switch (dialect) {
    case parser::Dialect::uw:
      // Measured as the rest is: without 1.0003 the edges of what is refracted move by a hundredth of a pixel
      // in five of the pictures, and without 1e-5 seven pixels of another differ.
      return {true, true, true, true, true, true, true, true, 1.0003, 1e-5};
    case parser::Dialect::hkust:
      return {.specular_reflects = true};
    default:
      return {};
  }
}

// As options and files name them: "utexas", "uw", "hkust".
inline constexpr std::array<std::string_view, 3> dialect_names{"utexas", "uw", "hkust"};

constexpr std::string_view name_of(parser::Dialect dialect) {
  return dialect_names[static_cast<std::size_t>(dialect)];
}

constexpr std::optional<parser::Dialect> dialect_named(std::string_view name) {
  for (std::size_t i = 0; i < dialect_names.size(); ++i) {
    if (dialect_names[i] == name) return static_cast<parser::Dialect>(i);
  }
  return std::nullopt;
}

}  // namespace trace
