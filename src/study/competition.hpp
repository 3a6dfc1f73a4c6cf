// Which settings compete in time and error, and which of them win.
#pragma once

#include <span>
#include <vector>

#include "study/front.hpp"
#include "study/results.hpp"

namespace trace {

// Not those that compute something else: other arithmetic, or more than the scene needs.
bool competes(const Setting& setting);

// Those of a scene that compete: what they cost, and their places in SceneResult::settings.
struct Competitors {
  std::vector<Cost> costs;
  std::vector<std::size_t> places;
};
Competitors competitors(const SceneResult& scene);

// The fastest of them with an error of at most `error`; none where none is that good.
const SettingResult* fastest_within(const SceneResult& scene, double error);

// Each setting that any of these scenes has, once: by axis, and in the order of their first scene.
std::vector<const Setting*> settings_of(std::span<const SceneResult> scenes);

}  // namespace trace
