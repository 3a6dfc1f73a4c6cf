// docs/language.md section 12.
#include "rendering/blocks.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_picture.hpp"

using namespace trace;
using namespace trace::test;

namespace {

RenderOptions blocks(double threshold, int size = 4, int width = 16) {
  RenderOptions options;
  options.width = width;
  options.blocks = {threshold, size};
  return options;
}

RenderOptions plain(int width = 16) {
  return blocks(0, 4, width);
}

// Grey that grows from left to right and from bottom to top: a texture over the whole window.
Scene ramp() {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  MappedMaterial material;
  material.emissive = 0;
  scene.textures.emplace_back(Image{2, 2, {80, 80, 80, 160, 160, 160, 0, 0, 0, 80, 80, 80}});
  add(scene, Square{}, at_origin(), material);
  return scene;
}

}  // namespace

TEST_CASE("a block whose corners are alike is filled from them, and only they are traced") {
  const Rendered filled = rendered(half_white(5), blocks(1));
  CHECK(filled.rays.primary == 16 * 4);  // of 4 x 4 blocks
  CHECK(filled.image.rgb == rendered(half_white(5), plain()).image.rgb);
}

TEST_CASE("between the corners of a block colours are bilinear") {
  // The ramp is linear, so filling it gives what tracing gives, up to the truncation to bytes.
  const Image filled = rendered(ramp(), blocks(1000)).image, traced = rendered(ramp(), plain()).image;
  int off = 0;
  for (std::size_t i = 0; i < filled.rgb.size(); ++i) {
    if (std::abs(filled.rgb[i] - traced.rgb[i]) > 1) ++off;
  }
  CHECK(off == 0);
  CHECK(red(filled, 15, 15) > 140);
}

TEST_CASE("a detail between the corners of a block is passed over") {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  // Pixel (6, 6) of 16, at (6/16, 6/16) of the picture: within the block from 4 to 7.
  add(scene, Square{}, moved(6 / 16.0 - 0.5, 6 / 16.0 - 0.5, 0) * scaled(0.01), emissive(Rgb(1)));
  CHECK(red(rendered(scene, plain()).image, 6, 6) == 255);
  CHECK(red(rendered(scene, blocks(1)).image, 6, 6) == 0);
}

TEST_CASE("a block whose corners differ by more than the threshold is split until every pixel is traced") {
  // White up to column 9 of 16: in the blocks from 8 to 11 the corners differ; their left halves are white,
  // the right ones black, so all 16 pixels of each are corners of halves of 2 x 2.
  const Scene scene = half_white(9.5 / 16 - 0.5);
  const Rendered split = rendered(scene, blocks(999));
  CHECK(split.image.rgb == rendered(scene, plain()).image.rgb);
  CHECK(split.rays.primary == 12 * 4 + 4 * 16);
}

TEST_CASE(
    "the threshold is in thousandths of the distance of colours, which white and black have sqrt(3) of") {
  const Scene scene = half_white(9.5 / 16 - 0.5);
  CHECK(rendered(scene, blocks(1733)).rays.primary == 16 * 4);
  CHECK(rendered(scene, blocks(1731)).rays.primary > 16 * 4);
}

TEST_CASE("blocks at the right and upper border are cut off there") {
  const int width = GENERATE(1, 2, 3, 5, 7, 18), size = GENERATE(2, 4, 8);
  const Scene scene = half_white(5);
  CHECK(rendered(scene, blocks(1, size, width)).image.rgb == rendered(scene, plain(width)).image.rgb);
}

TEST_CASE("blocks of two or fewer pixels trace every pixel") {
  const int size = GENERATE(1, 2);
  const Scene scene = half_white(GENERATE(0.013, -0.2));
  const Rendered traced = rendered(scene, blocks(1e6, size));
  CHECK(traced.rays.primary == 16 * 16);
  CHECK(traced.image.rgb == rendered(scene, plain()).image.rgb);
}
