// docs/language.md section 11. The window of half_white() is one unit wide, so `edge` is where the white ends
// in the picture, less one half; pixels are 1/20.
#include "rendering/antialias.hpp"

#include <algorithm>

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_picture.hpp"

using namespace trace;
using namespace trace::test;

namespace {

RenderOptions refined(int n = 3, double threshold = 100) {
  RenderOptions options;
  options.width = 20;
  options.antialiasing = {true, n, threshold};
  return options;
}

// Reds of one row from the left.
std::vector<int> row(const Image& image, int j) {
  std::vector<int> result;
  for (int i = 0; i < image.width; ++i) result.push_back(red(image, i, j));
  return result;
}

// What antialiasing makes of a picture it is given as if rendered: the pixels it changes, where every other
// sample is white. The picture is 3 x 3 of grey `background`, but for one pixel.
std::vector<int> changed(std::uint8_t background, int i, int j, const std::array<std::uint8_t, 3>& odd,
                         double threshold) {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, scaled(9, 9, 1), emissive(Rgb(1)));
  const SceneTree tree(scene);
  RenderOptions options = refined(2, threshold);
  options.width = 3;
  Progress progress;
  FrameRenderer frame(scene, tree, options, 3, 2, progress);
  Image before{3, 3, std::vector<std::uint8_t>(27, background)};
  std::copy(odd.begin(), odd.end(), pixel(before, i, j));
  Film film(before, false);
  antialias(frame, film);
  const Image& image = film.image();
  std::vector<int> result;
  for (int p = 0; p < 9; ++p) {
    if (!std::equal(pixel(image, p % 3, p / 3), pixel(image, p % 3, p / 3) + 3,
                    pixel(before, p % 3, p / 3))) {
      result.push_back(p);  // 0 to 2 is the lowest row
    }
  }
  return result;
}

}  // namespace

TEST_CASE("a pixel on an edge becomes the mean of its samples") {
  // The edge within the pixel that begins at column 10: of its samples at 0, 1/3 and 2/3, one or two are
  // white.
  const double third = 1.0 / 60;
  const auto one = row(rendered(half_white(0.5 * third), refined()).image, 10);
  CHECK(one[9] == 255);
  CHECK(one[10] == 85);  // int(255 / 3)
  CHECK(one[11] == 0);
  const auto two = row(rendered(half_white(1.5 * third), refined()).image, 10);
  CHECK(two[10] == 170);
  const auto all = row(rendered(half_white(2.5 * third), refined()).image, 10);
  CHECK(all[10] == 255);
  CHECK(all[11] == 0);
}

TEST_CASE("samples lie on a grid from the pixel's lower left corner, rows as well as columns") {
  // The same turned by a quarter: the white ends at a row.
  Scene scene = half_white(0);
  scene.objects.clear();
  add(scene, Square{}, moved(0, -1 + 0.5 / 80, 0) * scaled(2, 2, 1), emissive(Rgb(1)));
  const Image image = rendered(scene, refined(4)).image;  // rows of samples at 0, 1/4, 2/4, 3/4 of the pixel
  CHECK(red(image, 10, 9) == 255);
  CHECK(red(image, 10, 10) == 63);  // int(255 / 4)
  CHECK(red(image, 10, 11) == 0);
}

TEST_CASE("one sample a pixel changes nothing") {
  RenderOptions plain = refined();
  plain.antialiasing.enabled = false;
  const Scene scene = half_white(0.01);
  CHECK(rendered(scene, refined(1, 0)).image.rgb == rendered(scene, plain).image.rgb);
  CHECK(rendered(scene, refined(1, 0)).rays.primary == 400);
}

TEST_CASE("only marked pixels are traced again, n * n - 1 times each") {
  // Columns 10 (the last white) and 11 of the 20 rows are marked.
  CHECK(rendered(half_white(0.04), refined()).rays.primary == 400 + 2 * 20 * 8);
  CHECK(rendered(half_white(0.04), refined(3, 2000)).rays.primary == 400);
}

TEST_CASE("a pixel is compared with its right, upper and upper right neighbours, and both are marked") {
  // The odd pixel in the middle is the neighbour of all but its upper left and lower right: 6 and 2.
  CHECK(changed(100, 1, 1, {0, 0, 0}, 100) == std::vector<int>{0, 1, 3, 4, 5, 7, 8});
  CHECK(changed(100, 0, 0, {0, 0, 0}, 100) == std::vector<int>{0, 1, 3, 4});
  CHECK(changed(100, 2, 0, {0, 0, 0}, 100) == std::vector<int>{1, 2, 5});
}

TEST_CASE("pixels are marked where their bytes are further apart than the threshold") {
  const auto marked = [](const std::array<std::uint8_t, 3>& odd, double threshold) {
    return !changed(100, 1, 1, odd, threshold).empty();
  };
  CHECK(marked({126, 100, 100}, 100));        // 26 / 255 = 0.10196
  CHECK_FALSE(marked({125, 100, 100}, 100));  // 25 / 255 = 0.098
  CHECK(marked({115, 115, 115}, 100));        // sqrt(3) * 15 / 255 = 0.1019
  CHECK_FALSE(marked({114, 114, 114}, 100));  // sqrt(3) * 14 / 255 = 0.0951
  CHECK(marked({100, 100, 99}, 0));
  CHECK_FALSE(marked({100, 100, 100}, 0));
}

TEST_CASE("the sample at the corner is the picture's byte, and the others are limited to one") {
  // Bytes 100 in a scene that is twice as bright as white: (100/255 + 3) / 4.
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, scaled(9, 9, 1), emissive(Rgb(2)));
  const SceneTree tree(scene);
  RenderOptions options = refined(2);
  options.width = 2;
  Progress progress;
  FrameRenderer frame(scene, tree, options, 2, 2, progress);
  Film film(Image{2, 2, {100, 100, 100, 0, 0, 0, 100, 100, 100, 0, 0, 0}}, false);
  antialias(frame, film);
  CHECK(red(film.image(), 0, 0) == static_cast<int>((100 + 3 * 255) / 4));
  CHECK(red(film.image(), 1, 1) == static_cast<int>(3 * 255 / 4));
}
