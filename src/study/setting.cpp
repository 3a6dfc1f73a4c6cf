#include "study/setting.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trace {
namespace {

class Ladders {
 public:
  explicit Ladders(const LadderScene& scene) : scene_(scene) {}

  void samples() {
    for (const int n : {1, 2, 3, 4, 8}) {
      Setting& setting =
          n == 1 ? add(base_setting, Axis::samples, "one sample at the corner of each pixel", "")
                 : add(fmt::format("{0}x{0}", n), Axis::samples,
                       fmt::format("{0} x {0} samples in each pixel", n), fmt::format("--aa {}", n));
      setting.options.sampling.grid = n;
    }
  }

  void patterns() {
    add("nine points", Axis::patterns, "corners, middles of edges and centre of each pixel", "--nine-points")
        .options.sampling.nine_points = true;
  }

  void adaptive() {
    for (const int levels : {64, 32, 16, 8, 4, 2, 1}) {
      add(fmt::format("adaptive {}", levels), Axis::adaptive,
          fmt::format("samples by contrast, to some {} levels in a pixel on an edge", levels),
          fmt::format("--adaptive {}", levels))
          .options.sampling.threshold = levels;
    }
  }

  void budget() {
    for (const double levels : {4.0, 2.0, 1.0, 0.5, 0.25}) {
      add(fmt::format("budget {:g}", levels), Axis::budget,
          fmt::format("an error of at most {:g} levels", levels), fmt::format("--error-budget {:g}", levels))
          .error_budget = levels;
    }
  }

  void course_adaptive() {
    struct Step {
      int n, threshold;
    };
    for (const auto& [n, threshold] : {Step{2, 100}, Step{3, 100}, Step{3, 30}, Step{4, 30}, Step{8, 10}}) {
      const std::string text =
          fmt::format("{0} x {0} samples where neighbours differ by more than {1} thousandths", n, threshold);
      add(fmt::format("course {0}x{0} over {1}", n, threshold), Axis::course_adaptive, text, "")
          .options.antialiasing = {true, n, static_cast<double>(threshold)};
    }
  }

  void depth() {
    for (const int depth : scene_.depths) {
      if (depth >= scene_.options.depth) break;  // the rest are the base setting or change nothing
      add(fmt::format("depth {}", depth), Axis::depth, fmt::format("at most {} bounces", depth),
          fmt::format("-r {}", depth))
          .options.depth = depth;
    }
  }

  void contribution() {
    if (scene_.depths.size() < 2) return;
    for (const double least : {0.3, 0.1, 0.03, 0.01, 0.003}) {
      add(fmt::format("contribution {:g}", least), Axis::contribution,
          fmt::format("rays end that would add less than {:g} of what they see", least),
          fmt::format("--least-contribution {:g}", least))
          .options.shading.least_contribution = least;
    }
  }

  void resolution() {
    for (const int divisor : {4, 2}) {
      const int width = scene_.options.width / divisor;
      if (width < 1) continue;
      add(fmt::format("1/{} width", divisor), Axis::resolution,
          fmt::format("a picture of 1/{} the width, enlarged", divisor), fmt::format("-w {}", width))
          .divisor = divisor;
    }
  }

  void arithmetic() {
    struct Step {
      Arithmetic arithmetic;
      const char *name, *text;
    };
    for (const auto& [arithmetic, name, text] :
         {Step{Arithmetic::single, "float", "floats, 24 bits"},
          Step{Arithmetic::working, "double", "doubles, 53 bits"},
          Step{Arithmetic::extended, "extended", "long double, 64 bits: the truth of this axis"}}) {
      add(name, Axis::arithmetic, text, "").arithmetic = arithmetic;
    }
  }

  // Trees of everything modelled double with each bounce, so both are no deeper than a few.
  void needs() {
    const int depth = std::min(scene_.options.depth, 3);
    add("needed", Axis::needs, fmt::format("only what the scene needs, depth {}", depth),
        fmt::format("-r {}", depth))
        .options.depth = depth;
    Setting& everything =
        add("everything", Axis::needs, fmt::format("everything modelled, needed or not, depth {}", depth),
            fmt::format("-r {} --model-everything", depth));
    everything.options.depth = depth;
    everything.options.shading.model_everything = true;
  }

  std::vector<Setting> take() { return std::move(settings_); }

 private:
  Setting& add(std::string name, Axis axis, std::string text, std::string flags) {
    settings_.push_back(
        {std::move(name), axis, std::move(text), std::move(flags), scene_.options, 0, 1, std::nullopt});
    return settings_.back();
  }

  const LadderScene& scene_;
  std::vector<Setting> settings_;
};

}  // namespace

std::vector<Setting> ladders(const LadderScene& scene, const std::vector<Axis>& axes) {
  const auto wanted = [&](Axis axis) { return std::find(axes.begin(), axes.end(), axis) != axes.end(); };
  Ladders result(scene);
  result.samples();
  if (wanted(Axis::adaptive)) result.adaptive();
  if (wanted(Axis::budget)) result.budget();
  if (wanted(Axis::course_adaptive)) result.course_adaptive();
  if (wanted(Axis::depth)) result.depth();
  if (wanted(Axis::contribution)) result.contribution();
  if (wanted(Axis::resolution)) result.resolution();
  if (wanted(Axis::arithmetic)) result.arithmetic();
  if (wanted(Axis::needs)) result.needs();
  if (wanted(Axis::patterns)) result.patterns();
  return result.take();
}

}  // namespace trace
