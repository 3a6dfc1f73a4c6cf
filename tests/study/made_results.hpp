// Results of studies made by hand.
#pragma once

#include "study/results.hpp"

namespace trace::test {

inline SettingResult made_setting(const std::string& name, Axis axis, double ms, double error,
                                  double uncertainty = 0) {
  SettingResult own;
  own.setting.name = name;
  own.setting.axis = axis;
  own.setting.text = "text of " + name;
  own.time = {ms, 0.9 * ms, 1.1 * ms, 5};
  own.error = {error, error / 3, error * 20};
  own.uncertainty = uncertainty;
  return own;
}

inline SettingResult made_budget(double asked, double error) {
  SettingResult own = made_setting("budget " + std::to_string(asked), Axis::budget, 3, error);
  own.setting.error_budget = asked;
  return own;
}

inline SceneResult made_scene(const std::string& name, std::vector<SettingResult> settings) {
  SceneResult scene;
  scene.scene = name;
  scene.width = scene.height = 16;
  scene.depth = 5;
  scene.converged = {512, 8, 0.02, 0.1, 0, ""};
  scene.settings = std::move(settings);
  return scene;
}

// Uniform sampling whose error halves for four times the time, as that of noise does: time = 64 / error^2.
inline std::vector<SettingResult> made_uniform() {
  return {made_setting("1", Axis::samples, 1, 8), made_setting("2x2", Axis::samples, 4, 4),
          made_setting("4x4", Axis::samples, 16, 2)};
}

}  // namespace trace::test
