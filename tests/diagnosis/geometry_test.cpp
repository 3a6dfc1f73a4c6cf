// Shifts, flips and swapped channels.
#include <catch2/catch.hpp>

#include "tests/diagnosis/diagnosed.hpp"

namespace trace::test {
namespace {

const char* const whole_frames[] = {"features/sphere", "features/reflection", "features/texture_box",
                                    "features/coloured_lights"};

struct Shift {
  double x, y;  // of the samples, right and up: the content goes the other way
  const char* text;
};

}  // namespace

TEST_CASE("a picture sampled whole pixels away is said to be shifted the other way, by that many") {
  static constexpr Shift shifts[] = {
      {-1, 0, "shifted: shifted by 1 pixel to the right"},
      {2, 0, "shifted: shifted by 2 pixels to the left"},
      {0, -1, "shifted: shifted by 1 pixel up"},
      {0, 4, "shifted: shifted by 4 pixels down"},
      {-1, 3, "shifted: shifted by 1 pixel to the right and 3 pixels down"},
  };
  for (const char* scene : whole_frames) {
    const Raster reference = our_solution(scene);
    for (const Shift& shift : shifts) {
      Way way = right_way();
      way.shift_x = shift.x;
      way.shift_y = shift.y;
      INFO(scene);
      CHECK(diagnosed(reference, picture(our_scene(scene), way)) == shift.text);
    }
  }
}

TEST_CASE("a shift by more than four pixels is not diagnosed") {
  for (const char* scene : whole_frames) {
    Way way = right_way();
    way.shift_x = 6;
    INFO(scene);
    CHECK(diagnosed(our_solution(scene), picture(our_scene(scene), way)) == "nothing");
  }
}

TEST_CASE("a flipped picture is said to be flipped, and in which way") {
  for (const char* scene : whole_frames) {
    const Raster reference = our_solution(scene);
    INFO(scene);
    CHECK(diagnosed(reference, flipped(reference, true, false)) == "flipped: flipped left-right");
    CHECK(diagnosed(reference, flipped(reference, false, true)) == "flipped: flipped upside down");
    CHECK(diagnosed(reference, flipped(reference, true, true)) == "flipped: rotated by 180 degrees");
  }
}

TEST_CASE("a mirrored camera axis is a flip with a shift, as a pixel's sample is its corner") {
  for (const char* name : {"features/sphere", "features/reflection", "features/texture_box"}) {
    Scene scene = our_scene(name);
    scene.camera.right = -scene.camera.right;
    INFO(name);
    CHECK(diagnosed(our_solution(name), picture(scene, right_way())) ==
          "flipped: flipped left-right, and shifted by 1 pixel to the right");
  }
}

TEST_CASE("swapped channels are named") {
  for (const char* scene : whole_frames) {
    const Raster reference = our_solution(scene);
    INFO(scene);
    CHECK(diagnosed(reference, channels_swapped(reference)) == "channels-swapped: red and blue are swapped");
  }
}

}  // namespace trace::test
