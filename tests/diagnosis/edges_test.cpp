// Antialiasing and sampling positions.
#include <catch2/catch.hpp>

#include "tests/diagnosis/diagnosed.hpp"

namespace trace::test {
namespace {

const std::string edges = "edges: differs along edges only: antialiasing or sampling position";
const char* const outlined_scenes[] = {"features/sphere", "features/box", "features/coloured_lights",
                                       "features/groups"};

}  // namespace

TEST_CASE("a picture sampled at the middle of its pixels differs along edges only") {
  for (const char* scene : outlined_scenes) {
    Way way = right_way();
    way.shift_x = way.shift_y = 0.5;
    INFO(scene);
    CHECK(diagnosed(our_solution(scene), picture(our_scene(scene), way)) == edges);
  }
}

TEST_CASE("an antialiased picture differs along edges only, and so does one that lacks it") {
  for (const char* scene : outlined_scenes) {
    Way way = right_way();
    way.options.antialiasing.enabled = true;
    const Raster plain = our_solution(scene), smooth = picture(our_scene(scene), way);
    INFO(scene);
    CHECK(diagnosed(plain, smooth) == edges);
    CHECK(diagnosed(smooth, plain) == edges);
  }
}

}  // namespace trace::test
