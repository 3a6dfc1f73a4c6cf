// Where no single cause is clear, nothing is said.
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "tests/diagnosis/diagnosed.hpp"

namespace trace::test {
namespace {

const char* const unlike_scenes[] = {"features/sphere", "features/box", "features/reflection",
                                     "features/texture_box", "features/directional_light"};

Raster shadowless(const Scene& scene, Way way) {
  way.options.shading.shadows = false;
  return picture(scene, way);
}

}  // namespace

TEST_CASE("equal pictures have no diagnosis, nor have pictures with a handful of other pixels") {
  for (const char* scene : unlike_scenes) {
    const Raster reference = our_solution(scene);
    Raster test = reference;
    INFO(scene);
    CHECK(diagnosed(reference, test) == "nothing");
    for (std::size_t i = 0; i < 30; ++i) test.samples[i * 997] = 1 - test.samples[i * 997];
    CHECK(diagnosed(reference, test) == "nothing");
  }
}

TEST_CASE("noise has no diagnosis") {
  for (const char* scene : unlike_scenes) {
    const Raster reference = our_solution(scene);
    INFO(scene);
    for (const int levels : {2, 5, 10, 30})
      CHECK(diagnosed(reference, noisy(reference, levels, 7)) == "nothing");
  }
}

TEST_CASE("pictures of different scenes have no diagnosis") {
  for (const char* a : unlike_scenes)
    for (const char* b : unlike_scenes) {
      const Raster first = our_solution(a), second = our_solution(b);
      if (std::string(a) == b || first.height != second.height) continue;
      INFO(a << " and " << b);
      CHECK(diagnosed(first, second) == "nothing");
    }
}

TEST_CASE("two defects at once have no diagnosis") {
  const auto root = [](double v) { return std::sqrt(v); };
  // All with shadows of some size.
  for (const char* name : {"features/sphere", "features/cylinder", "features/cone"}) {
    const Scene scene = our_scene(name);
    const Raster reference = our_solution(name);
    Way moved = right_way();
    moved.shift_x = 2;
    INFO(name);
    CHECK(diagnosed(reference, toned(picture(scene, moved), root)) == "nothing");
    CHECK(diagnosed(reference, shadowless(scene, moved)) == "nothing");
    CHECK(diagnosed(reference, shadowless(lights_scaled(scene, 0.8), right_way())) == "nothing");
    CHECK(diagnosed(reference, channels_swapped(flipped(reference, true, false))) == "nothing");
  }
}

TEST_CASE("defects that are not known get none of the known names") {
  for (const char* name : {"features/sphere", "features/box", "features/cone"}) {
    const Scene scene = our_scene(name);
    const Raster reference = our_solution(name);
    INFO(name);
    Scene zoomed = scene;
    zoomed.camera.window_height *= 1.1;
    CHECK(diagnosed(reference, picture(zoomed, right_way())) == "nothing");
    CHECK(diagnosed(reference, picture(recolored_object(scene, 2), right_way())) == "nothing");
    CHECK(diagnosed(reference, picture(ambient_scaled(scene, 2), right_way())) == "nothing");
    CHECK(diagnosed(reference, picture(changed_materials(scene, [](Material& m) { m.diffuse *= 0.5; }),
                                       right_way())) == "nothing");
  }
}

TEST_CASE("pictures with samples that are not finite have no diagnosis") {
  const Raster reference = our_solution("features/sphere");
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Raster test = flipped(reference, true, false);
    test.samples[1000] = value;
    CHECK(diagnosed(reference, test) == "nothing");
  }
}

TEST_CASE("gray pictures and pictures with alpha are diagnosed as others") {
  const Raster reference = our_solution("features/sphere"), mirrored = flipped(reference, true, false);
  const auto with_channels = [](const Raster& rgb, int channels) {
    Raster raster = rgb;
    raster.channels = channels;
    raster.samples.clear();
    for (std::size_t i = 0; i < rgb.samples.size(); i += 3)
      for (int c = 0; c < channels; ++c)
        raster.samples.push_back(
            channels % 2 == 0 && c == channels - 1 ? 1.0F : rgb.samples[i + static_cast<std::size_t>(c)]);
    return raster;
  };
  for (const int channels : {1, 2, 4})
    CHECK(diagnosed(with_channels(reference, channels), with_channels(mirrored, channels)) ==
          "flipped: flipped left-right");
}

}  // namespace trace::test
