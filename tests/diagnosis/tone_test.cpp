// Gamma, brightness, and the ends of the range.
#include <catch2/catch.hpp>

#include <cmath>

#include "rendering/pixel.hpp"
#include "tests/diagnosis/diagnosed.hpp"

namespace trace::test {
namespace {

const char* const toned_scenes[] = {"features/sphere", "features/reflection", "features/texture_box",
                                    "features/directional_light"};

Tone power(double exponent) {
  return [exponent](double v) { return std::pow(clamped(v), exponent); };
}

double srgb(double v) {
  v = clamped(v);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

}  // namespace

TEST_CASE("gamma applied to the renderer's colours is diagnosed with its value") {
  for (const char* scene : toned_scenes) {
    const Raster reference = our_solution(scene);
    const auto with = [&](const Tone& tone) {
      Way way = right_way();
      way.tone = tone;
      return diagnosed(reference, picture(our_scene(scene), way));
    };
    INFO(scene);
    CHECK(with(power(1 / 2.2)) == "gamma: gamma 2.2 was applied");
    CHECK(with(power(1 / 1.8)) == "gamma: gamma 1.8 was applied");
    CHECK(with(power(2.2)) == "gamma: gamma 2.2 was removed");
    CHECK(with(srgb) == "gamma: the sRGB curve was applied");
  }
}

TEST_CASE("gamma applied to the finished bytes is diagnosed too") {
  for (const char* scene : toned_scenes) {
    const Raster reference = our_solution(scene);
    INFO(scene);
    CHECK(diagnosed(reference, toned(reference, power(1 / 2.2))) == "gamma: gamma 2.2 was applied");
    CHECK(diagnosed(reference, toned(reference, power(2.2))) == "gamma: gamma 2.2 was removed");
  }
}

TEST_CASE("all lights scaled by a factor are a scaled brightness with that factor") {
  for (const char* scene : {"features/sphere", "features/box", "features/directional_light"}) {
    const Raster reference = our_solution(scene);
    INFO(scene);
    CHECK(diagnosed(reference, picture(lights_scaled(our_scene(scene), 0.5), right_way())) ==
          "brightness: brightness is scaled by 0.50");
    CHECK(diagnosed(reference, picture(lights_scaled(our_scene(scene), 1.5), right_way())) ==
          "brightness: brightness is scaled by 1.50");
  }
}

TEST_CASE("a picture of one colour is said to be that") {
  for (const char* scene : toned_scenes) {
    const Raster reference = our_solution(scene);
    INFO(scene);
    CHECK(diagnosed(reference, toned(reference, [](double) { return 0.0; })) == "blank: black everywhere");
    CHECK(diagnosed(reference, toned(reference, [](double) { return 1.0; })) ==
          "blank: one colour everywhere: red 255, green 255, blue 255");
  }
}

TEST_CASE("bytes that wrap around where the reference is limited are said to") {
  for (const char* name : {"features/sphere", "features/cylinder", "features/directional_light"}) {
    // Overexposed, so that there is something to limit.
    const Scene scene = lights_scaled(our_scene(name), 2);
    Way wrapping = right_way();
    wrapping.wrap = true;
    INFO(name);
    CHECK(diagnosed(picture(scene, right_way()), picture(scene, wrapping)) ==
          "wrapped: colours over the limit wrap around instead of being limited to 255");
  }
}

}  // namespace trace::test
