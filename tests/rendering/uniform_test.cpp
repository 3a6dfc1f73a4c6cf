// The window of half_white() is one unit wide: pixels are 1/20, and column 10 is from x = 0 to x = 1/20.
#include "rendering/uniform.hpp"

#include "tests/rendering/sampled_scenes.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

constexpr double uniform_pixel = 1.0 / 20;

ColorImage uniformly_sampled(const Scene& scene, int n, double place = 0.5) {
  Stage stage(scene, sampling_options(20));
  Film film = stage.film();
  render_uniform(stage.frame(), film, n, Vec2(place));
  return film.colors();
}

}  // namespace

TEST_CASE("a pixel is the mean of n x n samples in the middles of its equal parts") {
  const int n = GENERATE(2, 3, 4, 5);
  for (int white = 0; white <= n; ++white) {
    INFO(white << " of " << n << " columns of samples are white");
    // The edge between two columns of samples.
    const ColorImage colors = uniformly_sampled(half_white(white * uniform_pixel / n), n);
    const auto share = static_cast<float>(static_cast<double>(white) / n);
    int wrong = 0;
    for (int y = 0; y < 20; ++y) {
      wrong += colors.at(9, y) != Rgb(1);
      wrong += colors.at(10, y) != Rgb(share);
      wrong += colors.at(11, y) != Rgb(0);
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("samples are spread over rows as over columns") {
  Scene scene = half_white(0);
  scene.objects.clear();
  add(scene, Square{}, moved(0, -1 + 0.75 * uniform_pixel, 0) * scaled(2, 2, 1), emissive(Rgb(1)));
  const ColorImage colors = uniformly_sampled(scene, 4);
  // White is below: rows count from the top.
  CHECK(colors.at(3, 10) == Rgb(1));
  CHECK(colors.at(3, 9) == Rgb(0.75));
  CHECK(colors.at(3, 8) == Rgb(0));
}

TEST_CASE("a grid of one is the course's sample at the corner of the pixel, not in its middle") {
  const Scene scene = half_white(0.25 * uniform_pixel);
  RenderOptions options = sampling_options(20);
  options.sampling.grid = 1;
  const Rendered one = rendered(scene, options);
  CHECK(red(one.image, 10, 7) == 255);
  CHECK(red(one.image, 11, 7) == 0);
  CHECK(one.rays.primary == 400);
  CHECK(uniformly_sampled(scene, 1).at(10, 7) == Rgb(0));
  options.sampling.grid = 4;
  const Rendered four = rendered(scene, options);
  CHECK(red(four.image, 10, 7) == 63);  // int(255 / 4)
  CHECK(four.rays.primary == 400 * 16);
}

TEST_CASE("samples may lie at another place of each part") {
  // At 1/8 and 5/8 of the pixel, at 1/4 and 3/4, at 3/8 and 7/8.
  const Scene scene = half_white(0.2 * uniform_pixel);
  CHECK(uniformly_sampled(scene, 2, 0.25).at(10, 5) == Rgb(0.5));
  CHECK(uniformly_sampled(scene, 2, 0.5).at(10, 5) == Rgb(0));
  CHECK(uniformly_sampled(half_white(0.8 * uniform_pixel), 2, 0.5).at(10, 5) == Rgb(1));
  CHECK(uniformly_sampled(half_white(0.8 * uniform_pixel), 2, 0.75).at(10, 5) == Rgb(0.5));
}

TEST_CASE("samples are limited to one before their mean is taken") {
  Scene scene = half_white(0.5 * uniform_pixel);
  scene.materials[0].values.emissive = {3, 0.5, -1};
  CHECK(uniformly_sampled(scene, 2).at(10, 5) == Rgb(0.5, 0.25, 0));
}

TEST_CASE("a channel that is undefined in one sample is black in its pixel, and the pixel counts once") {
  // Undefined in green, from 0.02 to 0.18 both ways; green to the left of it.
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, moved(0.1, 0.1, 0) * scaled(0.16), emissive(Rgb(0.25)) + transmissive({0.5, 0, 1}));
  add(scene, Square{}, moved(-0.48, 0.1, 0) * scaled(1, 0.16, 1), emissive({0, 1, 0}));
  RenderOptions options = sampling_options(20);
  options.sampling.grid = 2;
  const Rendered result = rendered(scene, options);
  CHECK(result.colors.at(9, 7) == Rgb(0, 1, 0));
  CHECK(result.colors.at(10, 7) == Rgb(0.125, 0, 0.125));
  CHECK(result.colors.at(11, 7) == Rgb(0.25, 0, 0.25));
  CHECK(result.non_finite.count == 16);  // columns 10 to 13, rows 6 to 9
  CHECK(result.non_finite.undefined == Channels(1));
}

TEST_CASE("bytes are cut from the colours that are kept, and keeping them changes nothing") {
  RenderOptions options = sampling_options(24);
  options.sampling.grid = GENERATE(1, 2);
  const Rendered kept = rendered(mixed_scene(), options);
  Film film(kept.colors.width(), kept.colors.height(), false);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) film.set(x, 23 - y, kept.colors.at(x, y));
  }
  // A colour may be rounded over a level as it becomes a float.
  int wrong = 0;
  for (std::size_t k = 0; k < film.image().rgb.size(); ++k)
    wrong += std::abs(film.image().rgb[k] - kept.image.rgb[k]) > (kept.image.rgb[k] == 255 ? 0 : 1);
  CHECK(wrong == 0);
  options.keep_colors = false;
  const Rendered plain = rendered(mixed_scene(), options);
  CHECK(plain.image.rgb == kept.image.rgb);
  CHECK(plain.colors.samples().empty());
}
