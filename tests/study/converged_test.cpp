// The truth of a study against pictures whose exact coverage is known: a white half-plane under a camera
// whose window is one unit wide.
#include "study/converged.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "study/picture_error.hpp"
#include "tests/support/scene_picture.hpp"

namespace trace::test {
namespace {

RenderOptions converged_options(int width, int depth = 5, int threads = 2) {
  RenderOptions options;
  options.width = width;
  options.depth = depth;
  options.threads = threads;
  return options;
}

Converged converged(const Scene& scene, const RenderOptions& options, bool fixed_depth = false) {
  return converge(scene, SceneTree(scene), options, fixed_depth);
}

// White where cos(angle) x + sin(angle) y < edge.
Scene turned_half_white(double angle, double edge) {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, turned(angle, 0, 0, 1) * moved(edge - 2, 0, 0) * scaled(4, 4, 1), emissive(Rgb(1)));
  return scene;
}

// The same picture by its area: along thin rows of each pixel the white is a line of known length. Its own
// error is below 1e-4 levels.
ColorImage covered(double angle, double edge, int width) {
  constexpr int rows = 400;
  ColorImage picture(width, width);
  for (int j = 0; j < width; ++j) {
    for (int i = 0; i < width; ++i) {
      double sum = 0;
      for (int row = 0; row < rows; ++row) {
        const double y = (j + (row + 0.5) / rows) / width - 0.5;
        const double end = ((edge - std::sin(angle) * y) / std::cos(angle) + 0.5) * width;
        sum += std::clamp(end - i, 0.0, 1.0);
      }
      picture.set(i, width - 1 - j, Rgb(sum / rows));
    }
  }
  return picture;
}

}  // namespace

TEST_CASE("the error that the truth says of itself bounds its true error on edges at any angle") {
  for (const double angle : {0.11, 0.37, 0.61, 0.785, 1.02, 1.3}) {
    const double edge = 0.0123 + angle / 50;
    const Converged truth = converged(turned_half_white(angle, edge), converged_options(16));
    const double off = picture_error(truth.colors, covered(angle, edge, 16)).root_mean_square;
    INFO("angle " << angle << ": " << off << " levels, said to be " << truth.error);
    CHECK(off <= truth.error);
    CHECK(truth.error < 2);
    CHECK(off > 0);
    CHECK(truth.samples == 1024);
  }
}

// Along an upright edge all pixels have the same error, so that one position says little: over many the mean
// square of what is said must be that of what is.
TEST_CASE("over upright edges at many places of a pixel the truth is as good as it says") {
  double said = 0, is = 0;
  for (int place = 0; place < 40; ++place) {
    const double edge = (place + 0.37) / 40 / 8;
    const Converged truth = converged(half_white(edge), converged_options(8));
    const double off = picture_error(truth.colors, covered(0, edge, 8)).root_mean_square;
    said += truth.error * truth.error;
    is += off * off;
  }
  CHECK(is > 0);
  CHECK(is <= said);
}

TEST_CASE("a picture without edges is known exactly and at depth 0") {
  const bool lit = GENERATE(true, false);
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  if (lit) add(scene, Square{}, scaled(9, 9, 1), emissive(Rgb(0.5)));
  const Converged truth = converged(scene, converged_options(12, 7));
  CHECK(truth.error == 0);
  CHECK(truth.depth == 0);
  CHECK(truth.settled_depth == 0);
  CHECK(truth.depths == std::vector<int>{0});
  CHECK(truth.colors.at(5, 5) == Rgb(lit ? 0.5 : 0));
}

TEST_CASE("the truth goes as deep as changes anything, and says where nothing more is lost") {
  // At depth d between these mirrors: 0.4 (1 - 2^-(d+1)).
  Scene scene;
  const Material wall = emissive(Rgb(0.2)) + reflective(Rgb(0.5));
  add(scene, Square{}, moved(0, 0, -1) * scaled(1e6, 1e6, 1), wall);
  add(scene, Square{}, moved(0, 0, 1) * scaled(1e6, 1e6, 1), wall);
  const Converged truth = converged(scene, converged_options(8));
  CHECK(255 * std::abs(truth.colors.at(3, 3).x - 0.4) <= truth.error);
  CHECK(truth.error < 0.05);
  CHECK(std::is_sorted(truth.depths.begin(), truth.depths.end()));
  CHECK(truth.depths.front() == 0);
  CHECK(truth.depths.back() == truth.depth);
  CHECK(truth.settled_depth < truth.depth);
  const double lost = 255 * 0.4 * std::pow(0.5, truth.settled_depth + 1);
  CHECK(lost < 0.1);
  CHECK(2 * lost > 0.01);

  SECTION("a depth that is fixed is the truth's own, and what is deeper is no error of it") {
    const Converged fixed = converged(scene, converged_options(8, 2), true);
    CHECK(fixed.depth == 2);
    CHECK(fixed.depths == std::vector<int>{0, 1, 2});
    CHECK(fixed.settled_depth == 2);
    CHECK(fixed.error == 0);
    CHECK(fixed.colors.at(3, 3).x == Approx(0.35));
  }
}

TEST_CASE("the truth is the same for any number of threads") {
  const Scene scene = turned_half_white(0.5, 0.1);
  const Converged one = converged(scene, converged_options(16, 5, 1));
  const Converged three = converged(scene, converged_options(16, 5, 3));
  CHECK(one.colors.samples() == three.colors.samples());
  CHECK(one.error == three.error);
}

}  // namespace trace::test
