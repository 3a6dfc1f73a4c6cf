// Lights in any kind of number; scene/light.hpp has the contracts.
#pragma once

#include "precision/numbers.hpp"
#include "scene/light.hpp"

namespace trace::precision {

template <class T>
struct LightSample {
  Vec3<T> towards;
  T distance, attenuation;
  bool reaches;
};

template <class T>
LightSample<T> sample(const DirectionalLight& light, const Vec3<T>&) {
  const Vec3<T> towards(light.towards);
  return {towards, std::numeric_limits<T>::infinity(), 1, is_finite(towards) && !is_zero(towards)};
}

// Not where the square of the distance is beyond the range of T.
template <class T>
LightSample<T> sample(const PointLight& light, const Vec3<T>& point) {
  const Vec3<T> to_light = Vec3<T>(light.position) - point;
  const T square = glm::dot(to_light, to_light), s = std::sqrt(square);
  const T f = T(light.constant) + T(light.linear) * s + T(light.quadratic) * s * s;
  const bool reaches = square >= std::numeric_limits<T>::min() && square <= std::numeric_limits<T>::max();
  return {glm::normalize(to_light), s, f > 1 ? 1 / f : 1, reaches};
}

// Lights of dialects are not known here; render_in() takes no scene with one.
template <class T>
LightSample<T> sample(const SpotLight&, const Vec3<T>&) {
  return {Vec3<T>(0), 0, 0, false};
}
template <class T>
LightSample<T> sample(const AreaLight&, const Vec3<T>&) {
  return {Vec3<T>(0), 0, 0, false};
}

}  // namespace trace::precision
