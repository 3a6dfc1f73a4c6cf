// Pixels without a finite colour. The window of these pictures is from -1/2 to 1/2 at z = 0, in 20 pixels.
#include "rendering/non_finite.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_picture.hpp"

using namespace trace;
using namespace trace::test;

namespace {

RenderOptions small(int threads = 2) {
  RenderOptions options;
  options.width = 20;
  options.threads = threads;
  return options;
}

// A square from 0.005 to 0.195 both ways: columns 11 to 13, rows 6 to 8 from the top. It is undefined in
// green before black.
Scene undefined_square() {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, moved(0.1, 0.1, 0) * scaled(0.19), emissive(Rgb(0.25)) + transmissive({0.5, 0, 1}));
  return scene;
}

std::array<int, 3> bytes(const Image& image, int i, int j) {
  const std::uint8_t* p = pixel(image, i, j);
  return {p[0], p[1], p[2]};
}

}  // namespace

TEST_CASE("undefined channels are black, counted, and the first pixel is told in reading order") {
  const Rendered result = rendered(undefined_square(), small(GENERATE(1, 2, 7)));
  CHECK(bytes(result.image, 12, 12) == std::array<int, 3>{63, 0, 63});
  CHECK(result.non_finite.count == 9);
  CHECK(result.non_finite.x == 11);
  CHECK(result.non_finite.y == 6);
  CHECK(result.non_finite.undefined == Channels(1));
  CHECK_FALSE(result.non_finite.infinite.any());
}

TEST_CASE("infinite channels are limited like others, and counted") {
  Scene scene = undefined_square();
  const Texture grey(Image{1, 1, {100, 100, 0}});
  scene.cube_map = CubeMap(std::vector<Texture>(6, grey));
  scene.objects[0].material = 1;
  scene.materials.push_back({transmissive({0, 0.5, 0})});
  const Rendered result = rendered(scene, small());
  CHECK(bytes(result.image, 12, 12) == std::array<int, 3>{255, 200, 0});
  CHECK(result.non_finite.count == 9);
  CHECK(result.non_finite.infinite == Channels(0));
  CHECK(result.non_finite.undefined == Channels(2));
}

TEST_CASE("a finite picture has no such pixel, however bright") {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, at_origin(), emissive({1e300, -1e300, 5e-324}));
  CHECK(rendered(scene, small()).non_finite.count == 0);
}

TEST_CASE("an undefined sample makes its channel of a refined pixel black, and the pixel counts once") {
  // Green up to x = 0.004, so that the corner of column 10 is green and its other samples are undefined.
  Scene scene = undefined_square();
  add(scene, Square{}, moved(-0.498, 0.1, 0) * scaled(1.004, 0.19, 1), emissive({0, 1, 0}));
  RenderOptions options = small();
  CHECK(bytes(rendered(scene, options).image, 10, 12) == std::array<int, 3>{0, 255, 0});
  options.antialiasing = {true, 3, 100};
  const Rendered refined = rendered(scene, options);
  CHECK(bytes(refined.image, 10, 12) == std::array<int, 3>{42, 0, 42});  // 6 of 9 samples of 0.25
  CHECK(bytes(refined.image, 9, 12) == std::array<int, 3>{0, 255, 0});
  // Columns 10 to 13, rows 6 to 9 from the top: the lowest has samples inside too.
  CHECK(refined.non_finite.count == 16);
  CHECK(refined.non_finite.x == 10);
  CHECK(refined.non_finite.y == 6);
}

TEST_CASE("a block with an undefined corner is split, whatever the threshold") {
  const Scene scene = undefined_square();
  RenderOptions options = small();
  const Rendered plain = rendered(scene, options);
  options.blocks = {1e6, 4};
  const Rendered blocks = rendered(scene, options);
  CHECK(blocks.image.rgb == plain.image.rgb);
  CHECK(blocks.non_finite.count == 9);
  // Pixels 11 to 13 are in four blocks and a corner of each; the other 21 are alike.
  CHECK(blocks.rays.primary == 4 * 16 + 21 * 4);
}

TEST_CASE("the message names count, place and channels") {
  NonFinitePixels found{12, 31, 40, Channels(1), {}};
  CHECK(to_text(found) ==
        "12 pixels have a colour that is not finite, the first at (31, 40): green is undefined and drawn "
        "black");
  found.infinite = Channels(0) | Channels(2);
  CHECK(to_text(found) ==
        "12 pixels have a colour that is not finite, the first at (31, 40): red and blue are infinite, green "
        "is "
        "undefined and drawn black");
  found = {1, 0, 0, {}, Channels(0) | Channels(1) | Channels(2)};
  CHECK(to_text(found) ==
        "one pixel has a colour that is not finite, at (0, 0): red, green and blue are infinite");
}

TEST_CASE("a camera that looks nowhere draws the background") {
  Scene scene;
  add(scene, Sphere{}, at_origin(), emissive(Rgb(1)));  // the eye is in its middle
  std::vector<Texture> faces(5, Texture(Image{1, 1, {0, 0, 0}}));
  faces.emplace_back(Image{2, 2, {0, 0, 0, 0, 0, 0, 100, 255, 0, 0, 0, 0}});
  scene.cube_map = CubeMap(std::move(faces));
  const bool zero = GENERATE(true, false);
  scene.camera.set_view(zero ? Vec3(0) : Vec3(0, 0, -1e200), zero ? Vec3(0) : Vec3(0, 1, 0));
  const Rendered result = rendered(scene, small());
  CHECK(bytes(result.image, 3, 5) == std::array<int, 3>{100, 255, 0});  // the lower left corner of negz
  CHECK(result.non_finite.count == 0);
}
