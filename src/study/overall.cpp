#include "study/overall.hpp"

#include <algorithm>
#include <cmath>

#include "study/competition.hpp"

namespace trace {
namespace {

class GeometricMean {
 public:
  void add(double value) {
    sum_ += std::log(value);
    low_ = count_ == 0 ? value : std::min(low_, value);
    high_ = count_ == 0 ? value : std::max(high_, value);
    ++count_;
  }
  std::size_t count() const { return count_; }
  double value() const { return count_ == 0 ? 0 : std::exp(sum_ / static_cast<double>(count_)); }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double sum_ = 0, low_ = 0, high_ = 0;
  std::size_t count_ = 0;
};

const SettingResult* find(const SceneResult& scene, const std::string& name) {
  for (const SettingResult& own : scene.settings) {
    if (own.setting.name == name) return &own;
  }
  return nullptr;
}

// The error as far as it is known.
double known_error(const SettingResult& own) {
  return std::max(own.error.root_mean_square, own.uncertainty);
}

bool says_something(const SettingResult& base) {
  return base.error.root_mean_square > 2 * base.uncertainty && base.error.root_mean_square > 0;
}

Claim claim(const std::string& text, const GeometricMean& mean) {
  return {text, mean.value(), mean.low(), mean.high(), mean.count()};
}

// What is known of an error is subtracted in favour of neither: it counts as measured.
std::vector<BudgetKept> kept_budgets(std::span<const SceneResult> scenes) {
  std::vector<BudgetKept> result;
  for (const SceneResult& scene : scenes) {
    for (const SettingResult& own : scene.settings) {
      const double asked = own.setting.error_budget;
      if (asked == 0) continue;
      auto line =
          std::find_if(result.begin(), result.end(), [&](const BudgetKept& b) { return b.asked == asked; });
      if (line == result.end()) line = result.insert(result.end(), {asked});
      const double times = own.error.root_mean_square / asked;
      ++line->scenes;
      line->within += times <= 1;
      line->nearly += times <= 1.5;
      line->worst = std::max(line->worst, times);
    }
  }
  return result;
}

}  // namespace

double speed_up_at_equal_error(const SceneResult& scene, Axis axis) {
  struct Step {
    double error, time;
  };
  std::vector<Step> uniform;  // errors falling
  for (const SettingResult& own : scene.settings) {
    if (own.setting.axis != Axis::samples || !(own.error.root_mean_square > 0)) continue;
    if (uniform.empty() || own.error.root_mean_square < uniform.back().error)
      uniform.push_back({own.error.root_mean_square, own.time.median});
  }
  GeometricMean mean;
  for (const SettingResult& own : scene.settings) {
    const double error = own.error.root_mean_square;
    if (own.setting.axis != axis || error <= 2 * own.uncertainty) continue;
    for (std::size_t k = 1; k < uniform.size(); ++k) {
      const Step &worse = uniform[k - 1], &better = uniform[k];
      if (error > worse.error || error < better.error) continue;
      const double share = std::log(worse.error / error) / std::log(worse.error / better.error);
      const double time = worse.time * std::pow(better.time / worse.time, share);
      mean.add(time / own.time.median);
      break;
    }
  }
  return mean.value();
}

Overall overall(std::span<const SceneResult> scenes) {
  Overall result;
  result.scenes = scenes.size();
  GeometricMean adaptive, course, needs, single;
  for (const SceneResult& scene : scenes) {
    const auto add_speed_up = [&](GeometricMean& mean, Axis axis) {
      if (const double times = speed_up_at_equal_error(scene, axis); times > 0) mean.add(times);
    };
    add_speed_up(adaptive, Axis::adaptive);
    add_speed_up(course, Axis::course_adaptive);
    const SettingResult *needed = find(scene, "needed"), *everything = find(scene, "everything");
    if (needed && everything) needs.add(everything->time.median / needed->time.median);
    const SettingResult *in_float = find(scene, "float"), *in_double = find(scene, "double");
    if (in_float && in_double) single.add(in_double->time.median / in_float->time.median);
  }

  std::vector<Cost> costs;
  for (const Setting* setting : settings_of(scenes)) {
    if (!competes(*setting)) continue;
    GeometricMean time, error;
    for (const SceneResult& scene : scenes) {
      const SettingResult *own = find(scene, setting->name), *base = find(scene, base_setting);
      if (!own || !base || !says_something(*base)) continue;
      time.add(own->time.median / base->time.median);
      error.add(known_error(*own) / base->error.root_mean_square);
    }
    if (time.count() == 0) continue;
    result.settings.push_back({setting->name, time.value(), error.value(), time.count()});
    costs.push_back({time.value(), error.value()});
  }
  const std::vector<bool> front = pareto_front(costs);
  for (std::size_t k = 0; k < front.size(); ++k) result.settings[k].front = front[k];

  const auto add_claim = [&](const char* text, const GeometricMean& mean) {
    if (mean.count() > 0) result.claims.push_back(claim(text, mean));
  };
  add_claim("adaptive sampling against uniform sampling of the same error", adaptive);
  add_claim("the course's antialiasing against uniform sampling of the same error", course);
  add_claim("modelling only what a scene needs against modelling everything, at the same picture", needs);
  add_claim("a plain tracer in float against the same in double", single);
  result.budgets = kept_budgets(scenes);
  return result;
}

}  // namespace trace
