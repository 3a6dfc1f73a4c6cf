#include "study/competition.hpp"

#include <algorithm>

namespace trace {

bool competes(const Setting& setting) {
  return !setting.arithmetic && setting.axis != Axis::needs;
}

Competitors competitors(const SceneResult& scene) {
  Competitors result;
  for (std::size_t k = 0; k < scene.settings.size(); ++k) {
    const SettingResult& own = scene.settings[k];
    if (!competes(own.setting)) continue;
    result.costs.push_back({own.time.median, own.error.root_mean_square});
    result.places.push_back(k);
  }
  return result;
}

const SettingResult* fastest_within(const SceneResult& scene, double error) {
  const Competitors all = competitors(scene);
  const int best = fastest_within(all.costs, error);
  return best < 0 ? nullptr : &scene.settings[all.places[static_cast<std::size_t>(best)]];
}

std::vector<const Setting*> settings_of(std::span<const SceneResult> scenes) {
  std::vector<const Setting*> settings;
  for (const SceneResult& scene : scenes) {
    for (const SettingResult& own : scene.settings) {
      const auto same = [&](const Setting* other) { return other->name == own.setting.name; };
      if (std::none_of(settings.begin(), settings.end(), same)) settings.push_back(&own.setting);
    }
  }
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting* a, const Setting* b) { return a->axis < b->axis; });
  return settings;
}

}  // namespace trace
