// What the picture loses when ray trees end early, on scenes where that is known.
#include "rendering/depth_pilot.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "rendering/frame_renderer.hpp"
#include "tests/rendering/sampled_scenes.hpp"

using namespace trace;
using namespace trace::test;

namespace {

DepthPilot piloted(const Scene& scene, int deepest, double enough, double most_rays = 1e9,
                   const RenderOptions& options = sampling_options(24)) {
  const SceneTree tree(scene);
  return pilot_depth(scene, tree, options, static_cast<int>(picture_height(scene, options.width)), deepest,
                     enough, most_rays);
}

std::vector<int> depths_of(const DepthPilot& pilot) {
  std::vector<int> depths;
  for (const DepthStep& step : pilot.steps) depths.push_back(step.depth);
  return depths;
}

}  // namespace

TEST_CASE("where nothing mirrors or lets light through there is only depth 0 and nothing is left") {
  const DepthPilot pilot = piloted(half_white(0.1), max_depth, 0.01);
  REQUIRE(depths_of(pilot) == std::vector<int>{0});
  CHECK(pilot.steps[0].error == 0);
  CHECK(pilot.steps[0].rays_per_sample == 1);
  CHECK(pilot.left == 0);
}

TEST_CASE("between facing mirrors the error falls from step to step, as the series does") {
  const double glow = 0.2, k = 0.5;
  const DepthPilot pilot = piloted(facing_mirrors(glow, k), max_depth, 0.01);
  const int deepest = pilot.steps.back().depth;
  REQUIRE(deepest > 6);
  const auto rest = [&](int depth) { return 255 * glow / (1 - k) * std::pow(k, depth + 1); };
  for (std::size_t s = 0; s < pilot.steps.size(); ++s) {
    const DepthStep& step = pilot.steps[s];
    INFO("depth " << step.depth);
    CHECK(step.depth == pilot_depths[s]);
    CHECK(step.error == Approx(rest(step.depth) - rest(deepest)).margin(1e-9));
    CHECK(step.rays_per_sample == step.depth + 1);
    if (s > 0) CHECK(step.error < pilot.steps[s - 1].error);
  }
  const int before = pilot.steps[pilot.steps.size() - 2].depth;
  CHECK(pilot.left == Approx(rest(before) - rest(deepest)));
  CHECK(pilot.left < 0.01);
}

TEST_CASE("the ladder ends when two steps in a row change less than what is enough") {
  const Scene scene = facing_mirrors(0.2, 0.5);
  const DepthPilot rough = piloted(scene, max_depth, 1), fine = piloted(scene, max_depth, 0.001);
  CHECK(rough.steps.back().depth < fine.steps.back().depth);
  CHECK(rough.left < 1);
  CHECK(fine.left < 0.001);
  const double last_but_one = rough.steps[rough.steps.size() - 3].error;
  CHECK(last_but_one < 2 * 1);  // what two small steps changed
}

TEST_CASE("the ladder ends at the deepest that is allowed, which is a step itself") {
  const Scene scene = facing_mirrors(0.05, 0.9);
  CHECK(depths_of(piloted(scene, 0, 0.01)) == std::vector<int>{0});
  CHECK(depths_of(piloted(scene, 3, 0.01)) == std::vector<int>{0, 1, 2, 3});
  const DepthPilot seven = piloted(scene, 7, 0.01);
  CHECK(depths_of(seven) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(seven.left > 1);
  CHECK(seven.steps.back().error == 0);
}

TEST_CASE(
    "the ladder ends before a step whose trees are larger than allowed, and says what that step would "
    "change") {
  // Trees of depth + 1 rays.
  const DepthPilot pilot = piloted(facing_mirrors(0.05, 0.9), max_depth, 0.001, 4.5);
  CHECK(depths_of(pilot) == std::vector<int>{0, 1, 2, 3});
  CHECK_FALSE(pilot.settled);
  CHECK(pilot.left == Approx(255 * 0.05 * std::pow(0.9, 4)).epsilon(0.01));
}

TEST_CASE("a ladder in which no ray goes deeper ends without a step that changes nothing") {
  // A mirror that sees the background: one bounce is all there is.
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, scaled(9, 9, 1), emissive(Rgb(0.5)) + reflective(Rgb(0.5)));
  const DepthPilot pilot = piloted(scene, max_depth, 1e-9);
  CHECK(depths_of(pilot) == std::vector<int>{0, 1});
  CHECK(pilot.left == 0);
}

TEST_CASE("a depth pilot sees the same with any number of threads, on pictures of any size") {
  const Scene scene = mixed_scene();
  const int width = GENERATE(1, 5, 100);  // the last has more pixels than are looked at
  const DepthPilot one = piloted(scene, 10, 0.01, 8'000'000, sampling_options(width, 5, 1));
  const DepthPilot two = piloted(scene, 10, 0.01, 8'000'000, sampling_options(width, 5, 2));
  REQUIRE(depths_of(one) == depths_of(two));
  CHECK(one.left == two.left);
  for (std::size_t k = 0; k < one.steps.size(); ++k) {
    CHECK(one.steps[k].error == two.steps[k].error);
    CHECK(one.steps[k].rays_per_sample == two.steps[k].rays_per_sample);
  }
}
