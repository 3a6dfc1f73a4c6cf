// What the picture loses with few samples, on pictures small enough that every edge is looked at.
#include "rendering/sampling_pilot.hpp"

#include <catch2/catch.hpp>

#include "study/picture_error.hpp"
#include "tests/rendering/sampled_scenes.hpp"

using namespace trace;
using namespace trace::test;

namespace {

SamplingPilot sampling_piloted(const Scene& scene, const RenderOptions& options) {
  Stage stage(scene, options);
  const CornerSamples corners(stage.frame());
  return pilot_sampling(stage.frame(), corners, corners.contrasts(stage.frame()));
}

// RMSE in levels of a picture that takes a step of the ladder everywhere.
double predicted(const SamplingPilot& pilot, std::size_t step) {
  double sum = 0, pixels = 0;
  for (const ContrastErrors& bin : pilot.bins) {
    sum += bin.pixels * bin.square[step];
    pixels += bin.pixels;
  }
  return std::sqrt(sum / pixels);
}

}  // namespace

TEST_CASE("the pilot of a flat picture reckons with no more than what it may not have seen") {
  const SamplingPilot pilot = sampling_piloted(flat_scene({1, 0.5, 0.25}), sampling_options(20));
  CHECK(pilot.bins[0].pixels == 400);
  for (const ContrastErrors& bin : pilot.bins) {
    if (bin.pixels == 0) continue;
    CHECK(bin.square.front() == unseen_square);
    CHECK(bin.square.back() == Approx(unseen_square / (16 * 16 * 16)));
  }
  CHECK(pilot.seconds_per_sample > 0);
}

TEST_CASE("the pilot of an edge finds the error of the corners, which is known") {
  // 5/12 of column 10 are white; the mean of its corners is one half.
  const SamplingPilot pilot = sampling_piloted(half_white(5.0 / 12 / 20), sampling_options(20));
  const ContrastErrors& edge = pilot.bins[static_cast<std::size_t>(contrast_bin(255))];
  CHECK(edge.pixels == 20);
  CHECK(edge.square[0] == Approx(255 * 255 / 144.0).epsilon(1e-5));
  CHECK(edge.square.back() < edge.square[0] / 10);
  const ContrastErrors& beside = pilot.bins[static_cast<std::size_t>(contrast_bin(255 / 4.0f))];
  CHECK(beside.pixels == 40);
  CHECK(beside.square[0] == unseen_square);
  CHECK(pilot.bins[0].pixels == 340);
}

TEST_CASE("errors fall or stay from step to step, and every pixel is in one bin") {
  const std::uint32_t seed = GENERATE(1u, 2u, 3u);
  const SamplingPilot pilot = sampling_piloted(random_materials_scene(seed), sampling_options(50));
  double pixels = 0;
  for (const ContrastErrors& bin : pilot.bins) {
    pixels += bin.pixels;
    for (std::size_t step = 1; step < bin.square.size(); ++step) {
      CHECK(bin.square[step] <= bin.square[step - 1]);
      CHECK(bin.square[step] >= 0);
    }
    if (bin.pixels == 0) CHECK(bin.square[0] == 0);
  }
  CHECK(pixels == 2500);
}

TEST_CASE("what the pilot predicts of a grid in every pixel is what the picture shows") {
  const Scene scene = mixed_scene();
  const RenderOptions options = sampling_options(48);
  const SamplingPilot pilot = sampling_piloted(scene, options);
  const ColorImage truth = finely_sampled(scene, options);
  for (const std::size_t step : {1u, 2u, 3u}) {
    RenderOptions gridded = options;
    gridded.sampling.grid = grid_ladder[step];
    const double measured = picture_error(rendered(scene, gridded).colors, truth).root_mean_square;
    INFO(int{grid_ladder[step]});
    CHECK(predicted(pilot, step) > measured / 1.4);
    CHECK(predicted(pilot, step) < measured * 1.4);
  }
}

TEST_CASE("a sampling pilot finds the same errors with any number of threads") {
  const Scene scene = mixed_scene();
  const SamplingPilot one = sampling_piloted(scene, sampling_options(40, 5, 1));
  const SamplingPilot three = sampling_piloted(scene, sampling_options(40, 5, 3));
  for (std::size_t bin = 0; bin < one.bins.size(); ++bin) {
    CHECK(one.bins[bin].pixels == three.bins[bin].pixels);
    CHECK(one.bins[bin].square == three.bins[bin].square);
  }
}
