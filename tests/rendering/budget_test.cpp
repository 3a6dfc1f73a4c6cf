// Pictures no worse, or no later, than asked.
#include "rendering/budget.hpp"

#include <algorithm>
#include <chrono>

#include "loading/scene_loader.hpp"
#include "rendering/adaptive.hpp"
#include "rendering/sampling_pilot.hpp"
#include "study/picture_error.hpp"
#include "tests/rendering/sampled_scenes.hpp"

using namespace trace;
using namespace trace::test;

namespace {

constexpr int budget_width = 32;

WithinBudget within(const Budget& budget, const Scene& scene, const RenderOptions& options) {
  const SceneTree tree(scene);
  Progress progress;
  return render_within(budget, scene, tree, options, progress);
}

// How many budgets were asked for, and kept, and nearly.
struct BudgetsKept {
  int asked = 0, kept = 0, nearly = 0;
};

void ask(const Scene& scene, BudgetsKept& count) {
  const ColorImage truth = finely_sampled(scene, sampling_options(budget_width, 12));
  for (const double error : {4.0, 2.0, 1.0, 0.5}) {
    const WithinBudget result = within({error, 0, false}, scene, sampling_options(budget_width));
    const double measured = picture_error(result.rendered.colors, truth).root_mean_square;
    ++count.asked;
    count.kept += measured <= error;
    count.nearly += measured <= 1.5 * error;
    CHECK(result.outcome.met == (result.outcome.error() <= error));
  }
}

Scene feature(const std::string& name) {
  FileImages images;
  LoadedScene loaded = load_scene(TRACE_SOURCE_DIR "/scenes/features/" + name + ".ray", budget_width, images);
  REQUIRE(loaded.scene);
  return std::move(*loaded.scene);
}

}  // namespace

TEST_CASE("the error that a budget asks for is kept on scenes of ours, within half as much again") {
  BudgetsKept count;
  for (const char* name : {"coloured_shadows", "cone", "reflection", "refraction", "trimesh_normals"})
    ask(feature(name), count);
  INFO(count.kept << " kept and " << count.nearly << " nearly of " << count.asked);
  CHECK(10 * count.nearly >= 9 * count.asked);
  CHECK(2 * count.kept >= count.asked);
}

TEST_CASE("the error that a budget asks for is kept on random scenes, within half as much again") {
  BudgetsKept count;
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) ask(random_materials_scene(seed), count);
  INFO(count.kept << " kept and " << count.nearly << " nearly of " << count.asked);
  CHECK(10 * count.nearly >= 9 * count.asked);
  CHECK(2 * count.kept >= count.asked);
}

TEST_CASE("a smaller error takes more samples, and not those of the finest grid everywhere") {
  const Scene scene = mixed_scene();
  double samples = 0;
  for (const double error : {8.0, 4.0, 2.0, 1.0, 0.5}) {
    const BudgetOutcome outcome = within({error, 0, false}, scene, sampling_options(budget_width)).outcome;
    INFO(error);
    CHECK(outcome.samples_per_pixel >= samples);
    CHECK(outcome.error() <= error);
    samples = outcome.samples_per_pixel;
  }
  CHECK(samples > 2);
  CHECK(samples < 100);
}

TEST_CASE("the picture for an error is the same on every run and for any number of threads") {
  const Scene scene = mixed_scene();
  const Budget budget{1, 0, false};
  const WithinBudget one = within(budget, scene, sampling_options(budget_width, 5, 1));
  for (const int threads : {1, 2, 3}) {
    const WithinBudget other = within(budget, scene, sampling_options(budget_width, 5, threads));
    INFO(threads);
    CHECK(other.rendered.image.rgb == one.rendered.image.rgb);
    CHECK(other.rendered.rays == one.rendered.rays);
    CHECK(other.outcome.depth == one.outcome.depth);
    CHECK(other.outcome.grids == one.outcome.grids);
    CHECK(other.outcome.error() == one.outcome.error());
  }
}

TEST_CASE("the picture of a budget is the one that its outcome says") {
  const Scene scene = mixed_scene();
  const WithinBudget result = within({1, 0, false}, scene, sampling_options(budget_width));
  Stage stage(scene, sampling_options(budget_width, result.outcome.depth));
  Film film = stage.film();
  render_adaptive(stage.frame(), film, result.outcome.grids);
  CHECK(film.image().rgb == result.rendered.image.rgb);
  const double pixels = budget_width * budget_width;
  CHECK(static_cast<double>(stage.frame().counts().primary) / pixels ==
        Approx(result.outcome.samples_per_pixel));
}

TEST_CASE("the depth for an error is as deep as it needs to be and no deeper") {
  const Scene mirrors = facing_mirrors(0.2, 0.5);
  int before = 0;
  for (const double error : {16.0, 4.0, 1.0, 0.25}) {
    const BudgetOutcome outcome = within({error, 0, false}, mirrors, sampling_options(16)).outcome;
    const double lost = 255 * 0.4 * std::pow(0.5, outcome.depth + 1);
    INFO("error " << error << ", depth " << outcome.depth);
    CHECK(outcome.met);
    CHECK(lost <= error);
    CHECK(outcome.depth > before);
    CHECK(255 * 0.4 * std::pow(0.5, outcome.depth - 2) > error / 4);
    before = outcome.depth;
  }
  CHECK(within({1, 0, false}, half_white(0.1), sampling_options(16, 50)).outcome.depth == 0);
}

TEST_CASE("a depth that is fixed is kept, and nothing deeper counts") {
  const Scene mirrors = facing_mirrors(0.2, 0.5);
  const WithinBudget shallow = within({1, 0, true}, mirrors, sampling_options(16, 1));
  CHECK(shallow.outcome.depth == 1);
  CHECK(shallow.outcome.depth_error == 0);
  CHECK(shallow.outcome.met);
  CHECK(shallow.rendered.colors.at(3, 3).x == Approx(0.3));
  const WithinBudget between = within({1, 0, true}, mirrors, sampling_options(16, 7));  // no step has it
  CHECK(between.outcome.depth == 7);
  CHECK(between.outcome.met);
  CHECK(within({1, 0, true}, half_white(0.1), sampling_options(16, 50)).outcome.depth == 50);
}

TEST_CASE("tiny, empty and black scenes have pictures within any budget") {
  const Budget budget = GENERATE(Budget{1, 0, false}, Budget{0, 10, false});
  Scene nothing, black, small = half_white(0.3);
  nothing.camera.eye = black.camera.eye = {0, 0, 1};
  add(black, Square{}, scaled(9, 9, 1), diffuse(Rgb(1)));
  for (const Scene* scene : {&nothing, &black, &small}) {
    for (const int width : {1, 2, 16}) {
      const WithinBudget result = within(budget, *scene, sampling_options(width));
      INFO("width " << width);
      CHECK(result.rendered.image.width == width);
      CHECK(result.rendered.image.rgb.size() == static_cast<std::size_t>(3 * width * width));
      CHECK(result.outcome.depth == 0);
      if (scene == &small) continue;
      CHECK(result.outcome.met);
      CHECK(result.outcome.error() <= std::sqrt(unseen_square));
      if (budget.error > 0) {  // more than the corners would show nothing
        CHECK(result.outcome.samples_per_pixel == Approx((width + 1.0) * (width + 1) / (width * width)));
      }
      CHECK(std::count(result.rendered.image.rgb.begin(), result.rendered.image.rgb.end(), 0) ==
            3 * width * width);
    }
  }
}

TEST_CASE("a picture that is not square has its budget too") {
  Scene scene = mixed_scene();
  scene.camera.aspect = 2.5;
  const WithinBudget result = within({1, 0, false}, scene, sampling_options(50));
  CHECK(result.rendered.image.height == 20);
  CHECK(result.rendered.colors.height() == 20);
  CHECK(result.outcome.error() <= 1);
}

TEST_CASE("an error that the finest samples do not reach is told as not met") {
  // Stripes much finer than a pixel.
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  for (int k = 0; k < 60; ++k)
    add(scene, Square{}, moved((k * 1.017 - 30) / 60, 0, 0) * scaled(0.008, 9, 1), emissive(Rgb(1)));
  const BudgetOutcome outcome = within({least_error, 0, false}, scene, sampling_options(16)).outcome;
  CHECK_FALSE(outcome.met);
  CHECK(outcome.error() > least_error);
  CHECK(outcome.samples_per_pixel > 100);
}

TEST_CASE("a time that is too short gives a picture all the same, soon, and says so") {
  const Scene scene = mixed_scene();
  for (const double seconds : {-1.0, 1e-6, 0.001}) {
    const auto begin = std::chrono::steady_clock::now();
    const WithinBudget result = within({0, seconds, false}, scene, sampling_options(200));
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    INFO(seconds);
    CHECK(result.rendered.image.rgb.size() == 200 * 200 * 3);
    CHECK(result.outcome.samples_per_pixel >= 1);
    CHECK(result.outcome.samples_per_pixel < 4);
    CHECK(spent.count() < 20);
    if (seconds < 1e-5) CHECK_FALSE(result.outcome.met);
  }
}

TEST_CASE("more time is a smaller error, until the ladder ends") {
  const Scene scene = mixed_scene();
  const WithinBudget hasty = within({0, 1e-6, false}, scene, sampling_options(budget_width));
  const WithinBudget patient = within({0, 60, false}, scene, sampling_options(budget_width));
  CHECK(patient.outcome.met);
  CHECK(patient.outcome.error() < hasty.outcome.error() / 4);
  CHECK(int{patient.outcome.grids.back()} == 16);
  const ColorImage truth = finely_sampled(scene, sampling_options(budget_width, 12));
  CHECK(picture_error(patient.rendered.colors, truth).root_mean_square <
        picture_error(hasty.rendered.colors, truth).root_mean_square / 4);
}
