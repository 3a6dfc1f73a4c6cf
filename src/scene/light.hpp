// Lights. Colours may exceed one or be negative.
#pragma once

#include <limits>
#include <variant>

#include "geometry/vector.hpp"

namespace trace {

// What a light is to one point: the unit vector towards it, how far it is, and what distance leaves of it.
struct LightSample {
  Vec3 towards;
  double distance;
  double attenuation;
};

struct DirectionalLight {
  Rgb color;
  Vec3 towards;  // unit length; not finite where the scene gives no direction

  LightSample sample(const Vec3&) const { return {towards, std::numeric_limits<double>::infinity(), 1.0}; }
};

// Attenuation 1 / (a + b s + c s^2) at distance s, at most 1. The coefficients are 32-bit numbers in the
// course's renderer.
struct PointLight {
  Rgb color;
  Vec3 position;
  float constant = 0, linear = 0, quadratic = 1;

  LightSample sample(const Vec3& point) const {
    const Vec3 to_light = position - point;
    const double s = glm::length(to_light);
    const double f = constant + linear * s + quadratic * s * s;
    return {glm::normalize(to_light), s, f > 1 ? 1 / f : 1};
  }
};

using Light = std::variant<DirectionalLight, PointLight>;

}  // namespace trace
