// The least contribution, which ends paths early (shading/contribution.hpp).
#include <catch2/catch.hpp>

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_everything.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

ShadingOptions at_least(double contribution) {
  ShadingOptions options;
  options.least_contribution = contribution;
  options.count_work = true;
  return options;
}

// Mirrors that face each other, each with light of its own; the ray comes through the back of one.
Scene mirrors(const Rgb& kr) {
  Scene scene;
  add(scene, Square{}, scaled(3), emissive(Rgb(0.25)) + reflective(kr));
  add(scene, Square{}, moved(0, 0, 6) * turned(3.141592653589793, 1, 0, 0) * scaled(3),
      emissive(Rgb(0.25)) + reflective(kr));
  return scene;
}

// A ball of glass two thick before a white wall.
Scene glass(const Rgb& kt) {
  Scene scene;
  add(scene, Sphere{}, at_origin(), transmissive(kt));
  add(scene, Square{}, moved(0, 0, -3) * scaled(40), emissive(Rgb(1)));
  return scene;
}

Scene room() {
  Scene scene;
  scene.camera = usual_camera();
  add(scene, Square{}, moved(0, -1, 0) * turned(-1.5, 1, 0, 0) * scaled(8),
      diffuse({0.5, 0.6, 0.7}) + reflective(Rgb(0.4)));
  add(scene, Sphere{}, moved(-0.7, 0, 0.5) * scaled(0.7),
      specular(Rgb(0.5), 20) + reflective({0.9, 0.5, 0.2}));
  add(scene, Sphere{}, moved(0.8, -0.2, 0.2) * scaled(0.6),
      transmissive({0.8, 0.5, 0.9}, 1.4) + reflective(Rgb(0.15)));
  add(scene, Box{}, moved(0.2, 0.9, -0.5) * turned(0.6, 1, 2, 0), diffuse(Rgb(0.3)) + reflective(Rgb(0.7)));
  scene.lights = {directional({0.2, -1, -0.4}), PointLight{Rgb(1), Vec3(2, 2, 3), 0.3f, 0.1f, 0}};
  surround(scene, {40, 80, 120});
  return scene;
}

Rendered room_at(double contribution, InstructionSet set) {
  RenderOptions options;
  options.width = 40;
  options.depth = 6;
  options.threads = 1;
  options.shading.least_contribution = contribution;
  return rendered_counting(room(), options, set, false);
}

double sum_of_differences(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(double(a.rgb[i]) - double(b.rgb[i]));
  return sum;
}

}  // namespace

TEST_CASE("a least contribution of 0, or one that every ray has, changes nothing") {
  const Rendered off = room_at(0, InstructionSet::baseline);
  const Rendered tiny = room_at(1e-300, InstructionSet::baseline);
  CHECK(off.rays.work.faint == 0);
  CHECK(tiny.rays == off.rays);
  CHECK(tiny.image.rgb == off.image.rgb);
}

TEST_CASE("a mirrored ray is traced while the product of what surfaces mirror is not below the least") {
  const Scene scene = mirrors({0.5, 0.25, -0.5});  // the largest channel counts, whatever its sign
  const auto mirrored = [&](double least) {
    const Traced result = traced(scene, from_front(), 20, at_least(least));
    CHECK(result.rays.work.faint == 1);
    return result.rays.reflected;
  };
  CHECK(mirrored(1) == 0);
  CHECK(mirrored(0.51) == 0);
  CHECK(mirrored(0.5) == 1);
  CHECK(mirrored(0.2) == 2);
  CHECK(mirrored(0.125) == 3);
  CHECK(seen(scene, 20, at_least(0.2)) == Rgb(0.25 * 1.75, 0.25 * 1.3125, 0.25 * 0.75));
}

TEST_CASE("with a least contribution of 1 mirrors that lose nothing are followed, others show direct light") {
  CHECK(traced(mirrors(Rgb(1)), from_front(), 20, at_least(1)).rays.reflected == 20);
  CHECK(seen(mirrors(Rgb(0.99)), 20, at_least(1)) == Rgb(0.25));
}

TEST_CASE("what glass takes over the way to a hit lowers the weight of the rays behind that hit") {
  const Scene scene = glass({0.1, 0.3, 0.2});  // at the far side 0.09 is left of green
  const auto refracted = [&](double least) {
    return traced(scene, from_front(), 5, at_least(least)).rays.refracted;
  };
  CHECK(refracted(0.089) == 2);
  CHECK(refracted(0.091) == 1);
  CHECK(refracted(1) == 1);  // into the glass everything goes
  CHECK(seen(scene, 5, at_least(0.089)) == seen(scene, 5));
  CHECK(seen(scene, 5, at_least(0.091)) == Rgb(0));
}

TEST_CASE("the rays of a greater least contribution are fewer and the picture no nearer to the whole one") {
  const Rendered whole = room_at(0, best_instruction_set());
  std::uint64_t rays = whole.rays.total();
  double error = 0;
  for (const double least : {0.003, 0.01, 0.03, 0.1, 0.3, 1.0}) {
    const Rendered found = room_at(least, best_instruction_set());
    CHECK(found.rays.total() < rays);
    const double difference = sum_of_differences(found.image, whole.image);
    CHECK(difference >= error);
    CHECK(found.rays.work.faint > 0);
    rays = found.rays.total();
    error = difference;
  }
  CHECK(error > 1000);
}

TEST_CASE("packets end paths where single rays do, with the same bits") {
  for (const double least : {1e-4, 0.01, 0.1, 0.5, 1.0}) {
    const Rendered single = room_at(least, InstructionSet::baseline);
    const Rendered packets = room_at(least, best_instruction_set());
    CHECK(packets.rays == single.rays);
    CHECK(packets.image.rgb == single.image.rgb);
  }
}

TEST_CASE("where everything is modelled a least contribution ends the same paths") {
  RenderOptions options;
  options.width = 24;
  options.depth = 4;
  options.threads = 1;
  options.shading.least_contribution = 0.1;
  const auto [needed, all] = needed_and_all(room(), options);
  CHECK(all.rays.reflected == needed.rays.reflected);
  CHECK(all.rays.work.faint == needed.rays.work.faint);
}
