// The window of half_white() is one unit wide: in 20 pixels column 10 is from x = 0 to x = 1/20.
#include "rendering/adaptive.hpp"

#include "study/picture_error.hpp"
#include "tests/rendering/sampled_scenes.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

RenderOptions adaptively(double threshold, int width = 20) {
  RenderOptions options = sampling_options(width);
  options.sampling = {1, threshold, 16};
  return options;
}

// n x n samples for one contrast in levels.
void set_grid(GridByContrast& grids, float contrast, std::uint8_t n) {
  grids[static_cast<std::size_t>(contrast_bin(contrast))] = n;
}

struct AdaptivePicture {
  ColorImage colors;
  std::uint64_t primary;
};

AdaptivePicture with_grids(const Scene& scene, int width, const GridByContrast& grids) {
  Stage stage(scene, sampling_options(width));
  Film film = stage.film();
  render_adaptive(stage.frame(), film, grids);
  return {film.colors(), stage.frame().counts().primary};
}

// Lit by a lamp near its middle: smooth all over.
Scene lamp_over_wall() {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  scene.lights = {PointLight{Rgb(1), Vec3(0.2, 0.1, 1.2), 0, 0, 1}};
  add(scene, Square{}, scaled(9, 9, 1), diffuse(Rgb(1)));
  return scene;
}

}  // namespace

TEST_CASE("a flat picture takes one sample a corner and no more") {
  RenderOptions options = adaptively(0.01);
  options.width = GENERATE(1, 20, 33);
  const auto corners = static_cast<std::uint64_t>(options.width + 1);
  const Rendered result = rendered(flat_scene({1, 0.5, 0.25}), options);
  CHECK(result.rays.primary == corners * corners);
  int wrong = 0;
  for (int y = 0; y < options.width; ++y) {
    for (int x = 0; x < options.width; ++x) wrong += result.colors.at(x, y) != Rgb(1, 0.5, 0.25);
  }
  CHECK(wrong == 0);
}

TEST_CASE("a pixel on an edge gets the grid of its contrast, and pixels beside it that of a quarter") {
  const Scene scene = half_white(0.6 / 20);  // of column 10 three fifths are white
  GridByContrast grids{};
  set_grid(grids, 255, 5);
  const AdaptivePicture edge = with_grids(scene, 20, grids);
  CHECK(edge.primary == 441 + 20 * 25);
  set_grid(grids, 255 / 4.0f, 3);
  const AdaptivePicture neighbours = with_grids(scene, 20, grids);
  CHECK(neighbours.primary == 441 + 20 * 25 + 2 * 20 * 9);
  for (const AdaptivePicture* picture : {&edge, &neighbours}) {
    int wrong = 0;
    for (int y = 0; y < 20; ++y) {
      wrong += picture->colors.at(9, y) != Rgb(1);
      wrong += picture->colors.at(10, y) != Rgb(0.6f);
      wrong += picture->colors.at(11, y) != Rgb(0);
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("an edge that enters a pixel between its corners is found by its neighbour") {
  // The point of a triangle reaches into the pixel of column 10 and row 10 between its left corners.
  Mesh mesh;
  mesh.points = {{-0.5, -0.193, 0}, {0.045, 0.025, 0}, {-0.5, 0.243, 0}};
  mesh.faces = {{0, 1, 2}};
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, mesh, at_origin(), emissive(Rgb(1)));
  const double covered = finely_sampled(scene, sampling_options(20)).at(10, 9).x;
  REQUIRE(covered > 0.2);
  const double found = rendered(scene, adaptively(1)).colors.at(10, 9).x;
  CHECK(found == Approx(covered).margin(0.03));
}

TEST_CASE("contrasts are found across the borders of tiles") {
  const int width = 130;
  const int column = GENERATE(0, 16, 63, 64, 65, 127, 128, 129);
  const Scene scene = half_white((column + 0.5) / width - 0.5);
  Stage stage(scene, sampling_options(width));
  const CornerSamples corners(stage.frame());
  const std::vector<std::uint8_t> bins = corners.contrasts(stage.frame());
  REQUIRE(bins.size() == 130 * 130);
  int wrong = 0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const int away = std::abs(static_cast<int>(k) % width - column);
    wrong += bins[k] != contrast_bin(away == 0 ? 255 : away == 1 ? 255 / 4.0f : 0);
  }
  CHECK(wrong == 0);
}

TEST_CASE("the mean of the corners is exact to second order where colours change smoothly") {
  const Scene scene = lamp_over_wall();
  const auto errors = [&](int width) {
    const ColorImage truth = finely_sampled(scene, sampling_options(width));
    const ColorImage corners = with_grids(scene, width, {}).colors;
    const ColorImage one = rendered(scene, sampling_options(width)).colors;
    return std::pair{picture_error(corners, truth).root_mean_square,
                     picture_error(one, truth).root_mean_square};
  };
  const auto [coarse, coarse_one] = errors(10);
  const auto [fine, fine_one] = errors(40);
  REQUIRE(fine > 0.001);
  CHECK(coarse / fine == Approx(16).epsilon(0.1));         // a quarter of the width: 4^2
  CHECK(coarse_one / fine_one == Approx(4).epsilon(0.1));  // one sample at the corner is of first order
}

TEST_CASE("adaptive pictures are the same for any number of threads and any instruction set") {
  const Scene scene = mixed_scene();
  RenderOptions options = adaptively(2, 40);
  options.threads = 1;
  options.instruction_set = InstructionSet::baseline;
  const Rendered expected = rendered(scene, options);
  CHECK(expected.rays.primary > 41 * 41 + 1000);
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::sse4, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    options.instruction_set = set;
    for (const int threads : {1, 2, 3}) {
      if (threads != 2 && set != InstructionSet::baseline && set != best_instruction_set()) continue;
      INFO(name_of(set) << ", " << threads << " threads");
      options.threads = threads;
      const Rendered other = rendered(scene, options);
      CHECK(other.image.rgb == expected.image.rgb);
      CHECK(other.colors.samples() == expected.colors.samples());
      CHECK(other.rays == expected.rays);
    }
  }
}

TEST_CASE("a smaller threshold never has a larger error and never fewer samples") {
  const Scene scene = mixed_scene();
  const ColorImage truth = finely_sampled(scene, adaptively(0, 40));
  double error = 255;
  std::uint64_t samples = 0;
  for (const double threshold : {128.0, 64.0, 32.0, 16.0, 8.0, 4.0, 2.0, 1.0, 0.5}) {
    const Rendered result = rendered(scene, adaptively(threshold, 40));
    const double own = picture_error(result.colors, truth).root_mean_square;
    INFO(threshold << ": " << own << " after " << error);
    CHECK(own <= error);
    CHECK(result.rays.primary >= samples);
    error = own;
    samples = result.rays.primary;
  }
  CHECK(error < 1);
  CHECK(samples < 40 * 40 * 256);
}

TEST_CASE("adaptive sampling is better than as many samples everywhere") {
  const Scene scene = mixed_scene();
  const ColorImage truth = finely_sampled(scene, adaptively(0, 60));
  const Rendered adaptive = rendered(scene, adaptively(8, 60));
  RenderOptions options = sampling_options(60);
  options.sampling.grid = 3;
  const Rendered uniform = rendered(scene, options);
  CHECK(adaptive.rays.primary < uniform.rays.primary);
  CHECK(picture_error(adaptive.colors, truth).root_mean_square <
        picture_error(uniform.colors, truth).root_mean_square);
}

TEST_CASE("a corner that is undefined counts as black, and its pixel is told of") {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, scaled(9, 9, 1), emissive(Rgb(0.25)) + transmissive({0.5, 0, 1}));
  const Rendered result = rendered(scene, adaptively(1));
  CHECK(result.colors.at(3, 4) == Rgb(0.25, 0, 0.25));
  CHECK(result.non_finite.count == 400);
  CHECK(result.rays.primary == 441);
}
