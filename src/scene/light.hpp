// Lights. Colours may exceed one or be negative.
#pragma once

#include <algorithm>
#include <limits>
#include <variant>
#include <vector>

#include "geometry/vector.hpp"
#include "scene/beam.hpp"

namespace trace {

// What a light is to one point: the unit vector towards it, how far it is, and what distance leaves of it.
// The other members count only where the light reaches the point: not where it has no direction from there.
struct LightSample {
  Vec3 towards;
  double distance;
  double attenuation;
  bool reaches = true;
};

// Without a direction (of length zero or not finite in the scene) it reaches nothing.
struct DirectionalLight {
  Rgb color;
  Vec3 towards;  // of unit length; zero or not finite where the scene gives no direction

  LightSample sample(const Vec3&) const {
    const bool has_direction = is_finite(towards) && !is_zero(towards);
    return {towards, std::numeric_limits<double>::infinity(), 1.0, has_direction};
  }
};

// Attenuation 1 / (a + b s + c s^2) at distance s, at most 1. The coefficients are 32-bit numbers in the
// course's renderer. It does not reach a point exactly in its position, nor one that is not finite or further
// away than the largest number.
struct PointLight {
  Rgb color;
  Vec3 position;
  float constant = 0, linear = 0, quadratic = 1;

  LightSample sample(const Vec3& point) const {
    const Vec3 to_light = position - point;
    const double square = glm::dot(to_light, to_light);
    if (!(square >= std::numeric_limits<double>::min() && square <= std::numeric_limits<double>::max())) {
      return sample_beyond_squares(to_light);
    }
    const double s = std::sqrt(square);
    return {glm::normalize(to_light), s, attenuation(constant + linear * s + quadratic * s * s)};
  }

 private:
  static double attenuation(double f) { return f > 1 ? 1 / f : 1; }

  // Where the square of the distance is not a normal number (nearer than 1.5e-154 or further than 1.3e154):
  // lengths are taken in units of the largest coordinate. In Horner's form no infinity meets its opposite or
  // 0.
  LightSample sample_beyond_squares(const Vec3& to_light) const {
    const double unit = std::max(std::max(std::abs(to_light.x), std::abs(to_light.y)), std::abs(to_light.z));
    if (!is_finite(to_light) || unit == 0) return {Vec3(0), 0, 0, false};
    const Vec3 direction = to_light / unit;  // its longest coordinate is 1
    const double s = unit * glm::length(direction);
    if (!std::isfinite(s)) return {Vec3(0), 0, 0, false};
    return {glm::normalize(direction), s, attenuation(constant + (linear + quadratic * s) * s)};
  }
};

// A point light whose light a beam limits: spot lights, Warn's lights, beams with a shape. It does not reach
// a point for which the beam leaves nothing of it.
struct SpotLight {
  Rgb color;
  Vec3 position;
  float constant = 0, linear = 0, quadratic = 0;  // as PointLight has them
  Beam beam;

  LightSample sample(const Vec3& point) const;
};

// Lights that all cast shadows of their own with hard edges.
using PlainLight = std::variant<DirectionalLight, PointLight, SpotLight>;

// A light with a size, which makes soft shadows: it stands for n x n lights on it that share its colour. They
// are the same for every point that is lit, so that pictures have no noise, and a soft edge has n^2 steps.
struct AreaLight {
  enum class Extent {
    parallelogram,  // position + s u + t v, s and t from 0 to 1
    disc,           // around the position; u and v are two of its radii, at right angles
    ball,           // around the position; u is a radius
  };
  Rgb color;
  Extent extent{};
  Vec3 position, u, v;
  float constant = 0, linear = 0, quadratic = 0;
  Beam beam;

  // In strata of equal light (Chiu, Shirley and Wang, "Multi-Jittered Sampling", Graphics Gems IV, 1994, with
  // the jitter that is the same in all rows and columns): seen along u or v no two are at the same place. A
  // ball is sampled so that it is an evenly bright disc from every side. Without limits of the beam they are
  // point lights. 1: one light, in the middle.
  std::vector<PlainLight> samples(int n) const;
};

using Light = std::variant<DirectionalLight, PointLight, SpotLight, AreaLight>;

}  // namespace trace
