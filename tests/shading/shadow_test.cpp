// docs/language.md section 8: from the origin towards a light along +z, with what stands between.
#include "shading/shadow.hpp"

#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Rgb kt(0.5, 0.25, 0.9);
const Material opaque{};

struct Shadow {
  Rgb left;
  Channels undefined;
  std::uint64_t rays;
};

Shadow shadow(const Scene& scene, double distance = infinity, const ShadingOptions& options = {}) {
  const SceneTree tree(scene);
  RayCounts counts;
  const PartialRgb left =
      shadow_attenuation(scene, tree, options, {Vec3(0), Vec3(0, 0, 1)}, distance, counts);
  return {left.value, left.undefined, counts.shadow};
}

}  // namespace

TEST_CASE("nothing in the way leaves the whole light") {
  CHECK(shadow(Scene{}).left == Rgb(1));
  CHECK(shadow(Scene{}).rays == 1);
}

TEST_CASE(
    "an opaque object before the light leaves nothing, one behind it all, in scenes with glass and without") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, 3), GENERATE(Material{}, emissive(Rgb(1)), reflective(Rgb(1))));
  if (GENERATE(false, true)) add(scene, Sphere{}, moved(50, 0, 0), transmissive(kt));
  CHECK(shadow(scene).left == Rgb(0));
  CHECK(shadow(scene, 2.6).left == Rgb(0));
  CHECK(shadow(scene, 2.4).left == Rgb(1));
  CHECK(shadow(scene, 2.5).left == Rgb(1));  // at the light's own distance: behind it
}

TEST_CASE("glass leaves kt to the power of its thickness") {
  const double thickness = GENERATE(0.5, 1.0, 2.0, 3.0);
  Scene scene;
  add(scene, Box{}, moved(0, 0, 4) * scaled(1, 1, thickness), transmissive(kt, GENERATE(1.0, 1.5)));
  CHECK(shadow(scene).left == near(glm::pow(kt, Rgb(thickness))));
  CHECK(shadow(scene).rays == 3);  // in, out, and on
}

TEST_CASE("a surface inside glass counts the glass from where it is") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, 0.5) * scaled(1, 1, 3), transmissive(kt));  // from z = -1 to 2
  CHECK(shadow(scene).left == near(glm::pow(kt, Rgb(2))));
}

TEST_CASE("glass that the light is in counts nothing, for it is never left") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, 2), transmissive(kt));
  CHECK(shadow(scene, 2).left == Rgb(1));
}

TEST_CASE("two glasses one behind the other both count, and an opaque object behind them ends it") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, 2), transmissive(kt));
  add(scene, Box{}, moved(0, 0, 4), transmissive({0.1, 1, 0.5}));
  CHECK(shadow(scene).left == near(kt * Rgb(0.1, 1, 0.5)));
  add(scene, Square{}, moved(0, 0, 9), opaque);
  CHECK(shadow(scene).left == Rgb(0));
  CHECK(shadow(scene, 8).left == near(kt * Rgb(0.1, 1, 0.5)));
}

TEST_CASE("of overlapping glasses each counts its way from the last crossing only") {
  // Enter A at 1, enter B at 2, leave A at 4 (2 since the last crossing), leave B at 5 (1).
  const Rgb a(0.5, 0.9, 0.3), b(0.7, 0.2, 0.6);
  Scene scene;
  add(scene, Box{}, moved(0, 0, 2.5) * scaled(1, 1, 3), transmissive(a));
  add(scene, Box{}, moved(0, 0, 3.5) * scaled(1, 1, 3), transmissive(b));
  CHECK(shadow(scene).left == near(a * a * b));
}

TEST_CASE("a transmissive square casts no shadow") {
  Scene scene;
  add(scene, Square{}, moved(0, 0, 2), transmissive(kt));
  CHECK(shadow(scene).left == Rgb(1));
}

TEST_CASE(
    "a transmissive triangle casts a shadow only if its normal points to the light, and is never culled") {
  Scene to_light, from_light;
  add(to_light, front_triangle(), moved(0, 0, 2), transmissive(kt));
  add(from_light, back_triangle(), moved(0, 0, 2), transmissive(kt));
  CHECK(shadow(to_light).left == near(kt * kt));  // from the surface, 2 away
  CHECK(shadow(from_light).left == Rgb(1));
  Scene black;
  add(black, GENERATE(true, false) ? front_triangle() : back_triangle(), moved(0, 0, 2), opaque);
  CHECK(shadow(black).left == Rgb(0));
}

TEST_CASE("without shadows nothing is in the way and no ray is cast") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, 3), opaque);
  ShadingOptions options;
  options.shadows = false;
  CHECK(shadow(scene, infinity, options).left == Rgb(1));
  CHECK(shadow(scene, infinity, options).rays == 0);
}

TEST_CASE("an occluder blocks however near it is, unless the point may lie on it") {
  Scene scene;
  add(scene, Square{}, moved(0, 0, GENERATE(1e-7, 1e-9, 1e-12, 1e-30)), opaque);
  CHECK(shadow(scene).left == Rgb(0));
  Scene at_the_point;
  add(at_the_point, Square{}, moved(0, 0, 0), opaque);
  CHECK(shadow(at_the_point).left == Rgb(1));
}

TEST_CASE("a material of points that mixes to no transmission is opaque there") {
  Scene scene;
  add(scene, front_triangle(), moved(0, 0, 2), Material{}, {transmissive(kt), transmissive(-kt), Material{}});
  CHECK(shadow(scene).left == Rgb(0));  // kt/4 - kt/4 at the middle
}

TEST_CASE("a walk through glass ends where coordinates are too large for steps to be told apart") {
  // At 1e9 neighbouring numbers are 1.2e-7 apart, more than the least distance of a hit.
  Scene scene;
  for (int i = 0; i < 4; ++i) {
    add(scene, Sphere{}, moved(1e9, 1e9, 1e9) * turned(i, 1, 2, 3) * scaled(1 + 1e-8 * i), transmissive(kt));
  }
  const SceneTree tree(scene);
  RayCounts counts;
  for (int i = 0; i < 200; ++i) {
    const double angle = i * 0.031;
    const Vec3 n(std::cos(angle), std::sin(angle) * 0.6, std::sin(angle) * 0.8);
    const Rgb left =
        shadow_attenuation(scene, tree, {}, {Vec3(1e9) + n, glm::normalize(Vec3(1, 1, 1))}, infinity, counts)
            .value;
    REQUIRE((left.x >= 0 && left.x <= 1));
  }
  CHECK(counts.shadow < 200 * 100);
}
