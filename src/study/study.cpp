#include "study/study.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "comparison/heat_map.hpp"
#include "comparison/measure.hpp"
#include "image/png.hpp"
#include "loading/scene_loader.hpp"
#include "process/process_files.hpp"
#include "rendering/budget.hpp"
#include "rendering/film.hpp"
#include "rendering/render.hpp"
#include "scene/beyond_course.hpp"
#include "study/competition.hpp"
#include "study/converged.hpp"

namespace trace {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Raster raster_of(const ColorImage& colors) {
  return {colors.width(), colors.height(), 3, SampleType::real, colors.samples()};
}

Image image_of(const ColorImage& colors) {
  Film film(colors.width(), colors.height(), false);
  for (int y = 0; y < colors.height(); ++y) {
    for (int x = 0; x < colors.width(); ++x) film.set(x, colors.height() - 1 - y, colors.at(x, y));
  }
  return std::move(film.image());
}

// What one run of a setting gives.
struct Run {
  ColorImage colors;
  Image image;
  RayCounts rays;
  double milliseconds = 0;
};

class SceneStudy {
 public:
  SceneStudy(const StudyScene& what, const StudyOptions& options, NamedPictures& pictures,
             std::string& warnings)
      : what_(what),
        options_(options),
        pictures_(pictures),
        warnings_(warnings),
        scene_(load(what, warnings)),
        base_(what.options) {
    base_.threads = threads_or_all(options.threads);
    tree_.emplace(scene_, base_.threads, base_.instruction_set);
  }

  SceneResult study() {
    truth_ = converge(scene_, *tree_, base_, what_.fixed_depth);
    fixed_depth_ = what_.fixed_depth || truth_.unsettled > 0;
    base_.depth = fixed_depth_ ? truth_.depth : truth_.settled_depth;
    result_.scene = what_.name;
    result_.width = base_.width;
    result_.height = truth_.colors.height();
    result_.depth = base_.depth;
    result_.converged = {truth_.samples, truth_.depth, truth_.error, truth_.seconds, truth_.unsettled, ""};
    read_solution();
    for (Setting& setting : ladders({base_, truth_.depths}, options_.axes)) {
      if (setting.arithmetic && !beyond_course(scene_).empty()) continue;  // it does not know such scenes
      if (picture_height(scene_, base_.width / setting.divisor) < 1) continue;  // of a very wide picture
      // The tracers of other arithmetic know the rules of utexas alone.
      if (setting.arithmetic && !scene_.rules.draws_as_utexas()) continue;
      if (setting.options.shading.model_everything)
        sorted_tree_.emplace(scene_, base_.threads, base_.instruction_set, true);
      result_.settings.push_back({});
      result_.settings.back().setting = std::move(setting);
    }
    warm_up();
    take_turns();
    mark_front();
    if (options_.pictures) draw_pictures();
    return std::move(result_);
  }

 private:
  static Scene load(const StudyScene& what, std::string& warnings) {
    FileImages images;
    LoadedScene loaded = load_scene(what.file, what.options, images);
    if (!loaded.scene) throw StudyError(loaded.messages);
    warnings += loaded.messages;
    warnings += add_cube_map(*loaded.scene, what.cube_map, images);
    return std::move(*loaded.scene);
  }

  void read_solution() {
    if (what_.solution.empty()) return;
    try {
      solution_ = to_raster(read_image(what_.solution));
    } catch (const ImageError& e) {
      throw StudyError(
          fmt::format("trace: error: cannot read '{}': {}\n", what_.solution.string(), e.what()));
    }
    if (solution_->width != result_.width || solution_->height != result_.height) {
      warnings_ += fmt::format("trace: warning: '{}' is {} x {}, the picture {} x {}: it is not compared\n",
                               what_.solution.string(), solution_->width, solution_->height, result_.width,
                               result_.height);
      solution_.reset();
    } else {
      result_.solution = what_.solution.string();
    }
  }

  Run run(const Setting& setting, bool keep) const {
    RenderOptions options = setting.options;
    options.width /= setting.divisor;
    options.keep_colors = keep;
    Run result;
    if (setting.arithmetic) {
      ArithmeticPicture picture = render_in(*setting.arithmetic, scene_, *tree_, options, options.threads);
      result.milliseconds = picture.seconds * 1000;
      result.rays = picture.rays;
      if (keep) {
        result.colors = ColorImage(picture.width, picture.height);
        std::transform(picture.colors.begin(), picture.colors.end(), result.colors.samples().begin(),
                       [](double c) { return static_cast<float>(c); });
      }
      return result;
    }
    Progress progress;
    const SceneTree& tree = options.shading.model_everything ? *sorted_tree_ : *tree_;
    const auto begin = Clock::now();
    Rendered rendered =
        setting.error_budget > 0
            ? render_within({setting.error_budget, 0, fixed_depth_}, scene_, tree, options, progress).rendered
            : render(scene_, tree, options, progress);
    result.milliseconds = milliseconds_since(begin);
    result.rays = rendered.rays;
    result.image = std::move(rendered.image);
    result.colors = std::move(rendered.colors);
    return result;
  }

  void warm_up() {
    for (SettingResult& own : result_.settings) {
      const bool counted = reset_peak_resident();
      Run first = run(own.setting, true);
      own.memory = counted ? peak_resident(getpid()) : 0;
      own.rays = first.rays;
      if (own.setting.divisor > 1) first.colors = enlarged(first.colors, result_.width, result_.height);
      own.error = picture_error(first.colors, truth_.colors);
      own.uncertainty = truth_.error;
      if (solution_) own.solution = solution_error(first, own.setting);
      if (own.setting.options.shading.model_everything) {
        own.same_picture = first.image.rgb == needed_.rgb;
      } else if (own.setting.axis == Axis::needs) {
        needed_ = first.image;
      }
      colors_.push_back(std::move(first.colors));
      expected_.push_back(first.milliseconds);
    }
    // The arithmetic's own error is against extended precision.
    const auto extended =
        std::find_if(result_.settings.begin(), result_.settings.end(),
                     [](const SettingResult& r) { return r.setting.arithmetic == Arithmetic::extended; });
    if (extended == result_.settings.end()) return;
    const ColorImage& truth = colors_[static_cast<std::size_t>(extended - result_.settings.begin())];
    for (std::size_t k = 0; k < colors_.size(); ++k) {
      SettingResult& own = result_.settings[k];
      if (!own.setting.arithmetic) continue;
      own.error = picture_error(colors_[k], truth);
      own.uncertainty = 0;
    }
  }

  SolutionError solution_error(const Run& run, const Setting& setting) const {
    // What is not a picture of its own is cut to bytes here.
    const Image image = setting.divisor > 1 || setting.arithmetic ? image_of(run.colors) : run.image;
    MeasureOptions options;
    options.ssim = options.flip = false;
    const Measurements m = measure(*solution_, to_raster(image), options);
    return {m.error.root_mean_square, m.percent_over_one};
  }

  // Rounds in which those settings take part whose times are not known well enough.
  void take_turns() {
    std::vector<std::vector<double>> times(result_.settings.size());
    const auto begin = Clock::now();
    for (int round = 0; round < options_.most_runs; ++round) {
      bool any = false;
      const std::vector<bool> wanted = undecided(times);
      for (std::size_t turn = 0; turn < times.size(); ++turn) {
        const std::size_t k = (turn + static_cast<std::size_t>(round)) % times.size();
        if (!wanted[k]) continue;
        const bool over = milliseconds_since(begin) + expected_[k] > 1000 * options_.seconds;
        // One run at least, however long it takes; the warming one is not among the times.
        if (over && !times[k].empty()) continue;
        times[k].push_back(run(result_.settings[k].setting, false).milliseconds);
        any = true;
      }
      if (!any) break;
    }
    for (std::size_t k = 0; k < times.size(); ++k) result_.settings[k].time = median_time(times[k]);
  }

  // Those whose interval still reaches over the median of the one that is next faster or slower.
  std::vector<bool> undecided(const std::vector<std::vector<double>>& times) const {
    std::vector<MedianTime> medians;
    for (const auto& own : times) medians.push_back(median_time(own));
    std::vector<bool> result;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const MedianTime& own = medians[k];
      bool open = own.runs < options_.least_runs;
      for (std::size_t other = 0; other < times.size() && !open; ++other) {
        if (other == k) continue;
        open = own.low <= medians[other].median && medians[other].median <= own.high;
      }
      // Within 2 % of each other they are equally fast for anyone.
      result.push_back(open && !(own.runs >= options_.least_runs && own.high - own.low < 0.02 * own.median));
    }
    return result;
  }

  void mark_front() {
    const auto [costs, places] = competitors(result_);
    const std::vector<bool> front = pareto_front(costs);
    for (std::size_t k = 0; k < places.size(); ++k) result_.settings[places[k]].front = front[k];
    // The fastest with no more than a level of error; else the most accurate.
    const int within = fastest_within(costs, 1);
    const auto least = std::min_element(costs.begin(), costs.end(),
                                        [](const Cost& a, const Cost& b) { return a.error < b.error; });
    result_.chosen = places[within >= 0 ? static_cast<std::size_t>(within)
                                        : static_cast<std::size_t>(least - costs.begin())];
  }

  void draw_pictures() {
    const auto keep = [&](const std::string& name, const Image& image) {
      pictures_[name] = encode_png(image, base_.threads);
      return name;
    };
    result_.converged.picture = keep(what_.name + " converged", image_of(truth_.colors));
    const Raster truth = raster_of(truth_.colors);
    for (std::size_t k = 0; k < result_.settings.size(); ++k) {
      SettingResult& own = result_.settings[k];
      const bool shown = own.front || k == result_.chosen || own.setting.name == base_setting;
      if (!shown) continue;
      const std::string name = fmt::format("{} {}", what_.name, own.setting.name);
      own.picture = keep(name, image_of(colors_[k]));
      if (k == result_.chosen || own.setting.name == base_setting)
        own.heat_map = keep(name + " heat", heat_map(truth, raster_of(colors_[k]), heat_amplification));
    }
  }

  // Errors of a few levels are to be seen.
  static constexpr double heat_amplification = 8;

  const StudyScene& what_;
  const StudyOptions& options_;
  NamedPictures& pictures_;
  std::string& warnings_;
  Scene scene_;
  RenderOptions base_;
  std::optional<SceneTree> tree_;
  std::optional<SceneTree> sorted_tree_;  // for where everything is modelled, if that is asked for
  Converged truth_;
  bool fixed_depth_ = false;  // deeper is not truth
  std::optional<Raster> solution_;
  Image needed_;                    // by modelling only what is needed
  std::vector<ColorImage> colors_;  // of each setting, enlarged
  std::vector<double> expected_;    // milliseconds of each
  SceneResult result_;
};

}  // namespace

SceneResult study_scene(const StudyScene& scene, const StudyOptions& options, NamedPictures& pictures,
                        std::string& warnings) {
  return SceneStudy(scene, options, pictures, warnings).study();
}

}  // namespace trace
