#include "tools/trace/study/study_text.hpp"

#include <fmt/format.h>

#include "study/competition.hpp"

namespace trace {
namespace {

constexpr double asked_errors[] = {4, 2, 1, 0.5, 0.25};

// Three digits, without an exponent where that can be avoided.
std::string digits(double value) {
  if (value == 0) return "0";
  if (value >= 100) return fmt::format("{:.0f}", value);
  if (value >= 10) return fmt::format("{:.1f}", value);
  return value >= 0.001 ? fmt::format("{:.3g}", value) : fmt::format("{:.1e}", value);
}

}  // namespace

std::string scene_text(const SceneResult& scene) {
  std::string text =
      fmt::format("{}, {} x {}, depth {}; truth: {} samples a pixel, depth {}, itself off by {} levels\n",
                  scene.scene, scene.width, scene.height, scene.depth, scene.converged.samples,
                  scene.converged.depth, digits(scene.converged.error));
  if (scene.converged.unsettled > 0) {
    text += fmt::format(
        "  ray trees grow too fast to go deeper, which would change some {} levels: depth {} counts as the "
        "truth\n",
        digits(scene.converged.unsettled), scene.converged.depth);
  }
  text += fmt::format("  {:<22} {:>9} {:>19}  {:>8} {:>8}  {:>10}\n", "setting", "ms", "", "error", "largest",
                      "rays");
  Axis axis = scene.settings.front().setting.axis;
  for (const SettingResult& own : scene.settings) {
    if (own.setting.axis != axis) text += '\n';
    axis = own.setting.axis;
    text +=
        fmt::format("{} {:<22} {:>9} {:>19}  {:>8} {:>8}  {:>10}{}\n", own.front ? '*' : ' ',
                    own.setting.name, digits(own.time.median),
                    fmt::format("({} to {}, {})", digits(own.time.low), digits(own.time.high), own.time.runs),
                    digits(own.error.root_mean_square), digits(own.error.largest), own.rays.total(),
                    own.same_picture ? (*own.same_picture ? "  the same picture" : "  ANOTHER PICTURE") : "");
  }
  text += "  * no setting is both faster and better; ms: median (interval, runs); error: RMSE in levels\n";
  for (const double error : asked_errors) {
    if (const SettingResult* own = fastest_within(scene, error)) {
      text += fmt::format("for an error below {:g} the fastest is {}: {} ms\n", error, own->setting.name,
                          digits(own->time.median));
    } else {
      text += fmt::format("for an error below {:g} none of these is enough\n", error);
    }
  }
  return text;
}

std::string overall_text(const Overall& all) {
  std::string text = fmt::format("{} scenes, relative to one sample a pixel (geometric means)\n", all.scenes);
  text += fmt::format("  {:<22} {:>8} {:>8} {:>7}\n", "setting", "time", "error", "scenes");
  for (const OverallSetting& own : all.settings) {
    text += fmt::format("{} {:<22} {:>8} {:>8} {:>7}\n", own.front ? '*' : ' ', own.name, digits(own.time),
                        digits(own.error), own.scenes);
  }
  text += "  * no setting is both faster and better\n";
  for (const Claim& claim : all.claims) {
    text += fmt::format("{}: {:.2f} times as fast ({:.2f} to {:.2f}, {} scenes)\n", claim.text, claim.times,
                        claim.low, claim.high, claim.scenes);
  }
  for (const BudgetKept& own : all.budgets) {
    text += fmt::format(
        "error budget of {:g}: kept in {} of {} scenes, within 1.5 times in {} ({:.1f} %), {:.2f} times at "
        "worst\n",
        own.asked, own.within, own.scenes, own.nearly,
        100.0 * static_cast<double>(own.nearly) / static_cast<double>(own.scenes), own.worst);
  }
  return text;
}

}  // namespace trace
