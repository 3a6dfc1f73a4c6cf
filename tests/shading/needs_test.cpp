// What is not modelled because it adds nothing: counters prove it, and the picture is the same where it is
// modelled all the same (scene/needs.hpp).
#include <catch2/catch.hpp>

#include "tests/support/scene_everything.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

constexpr int width = 24;
constexpr std::uint64_t pixels = width * width;

RenderOptions small(int depth = 0) {
  RenderOptions options;
  options.width = width;
  options.depth = depth;
  options.threads = 1;
  return options;
}

// A wall that fills the picture, facing the viewer.
Scene wall(const Material& material, const std::vector<Light>& lights) {
  Scene scene;
  scene.camera = usual_camera();
  add(scene, Square{}, scaled(20), material);
  scene.lights = lights;
  return scene;
}

// Balls on a floor before a wall, with lights all around.
Scene still_life(const Material& ball, const Material& floor) {
  Scene scene;
  scene.camera = usual_camera();
  add(scene, Square{}, moved(0, -1, 0) * turned(-1.5, 1, 0, 0) * scaled(6), floor);
  add(scene, Sphere{}, moved(-0.6, -0.3, 0.5) * scaled(0.6), ball);
  add(scene, Sphere{}, moved(0.7, -0.2, -0.4) * scaled(0.8), ball);
  add(scene, Box{}, moved(0, 1, 0) * turned(0.7, 1, 2, 3), floor);
  add(scene, Cylinder{}, moved(1.2, 0.7, 0.3) * scaled(0.3), ball);
  scene.lights = {directional({0.3, -1, -0.5}), directional({1, 0.2, 1}, {0.2, 0.3, 0.4}),
                  PointLight{Rgb(2), Vec3(-2, 2, 2), 0.2f, 0.1f, 0.05f}};
  return scene;
}

}  // namespace

TEST_CASE("an opaque scene that mirrors nothing sends no mirrored and no refracted rays") {
  const auto [needed, all] =
      needed_and_all(still_life(diffuse({1, 0.5, 0}), specular(Rgb(0.5), 9)), small(3));
  CHECK(needed.rays.reflected == 0);
  CHECK(needed.rays.refracted == 0);
  CHECK(all.rays.reflected > pixels);
  CHECK(all.rays.refracted > pixels);
}

TEST_CASE("a light behind a surface costs no shadow ray") {
  const auto [needed, all] = needed_and_all(wall(diffuse(Rgb(0.5)), {directional({0.1, 0, 1})}), small());
  CHECK(needed.rays.shadow == 0);
  CHECK(needed.rays.work.shadows.behind == pixels);
  CHECK(needed.rays.work.shadows.total() == pixels);
  CHECK(all.rays.shadow == pixels);
  CHECK(all.rays.work.shadows.total() == 0);
}

TEST_CASE("a surface without diffuse and specular colour costs no shadow ray") {
  Scene scene = wall(emissive(Rgb(0.5)), {directional({0, 0, -1}), directional({1, 0, -1})});
  add(scene, Sphere{}, moved(0, 0, -9), diffuse(Rgb(1)));  // not seen; without it no light would count
  const auto [needed, all] = needed_and_all(scene, small());
  CHECK(needed.rays.shadow == 0);
  CHECK(needed.rays.work.shadows.reflects_nothing == 2 * pixels);
  CHECK(all.rays.shadow == 2 * pixels);
}

TEST_CASE("an opaque surface seen from its back costs no shadow ray") {
  Scene scene;
  scene.camera = usual_camera();
  add(scene, Sphere{}, scaled(9), diffuse(Rgb(0.5)));
  scene.lights = {PointLight{Rgb(1), Vec3(0)}};
  const auto [needed, all] = needed_and_all(scene, small());
  CHECK(needed.rays.shadow == 0);
  CHECK(needed.rays.work.shadows.from_back == pixels);
  CHECK(all.rays.shadow == pixels);
}

TEST_CASE("a light that has no direction from a surface costs no shadow ray, even where all is modelled") {
  Scene scene;
  add(scene, Square{}, at_origin(), diffuse(Rgb(0.5)));
  scene.lights = {PointLight{Rgb(1), Vec3(0)}};
  ShadingOptions options;
  options.count_work = true;
  options.model_everything = GENERATE(false, true);
  const Traced seen = traced(scene, from_front(), 0, options);
  CHECK(seen.rays.shadow == 0);
  CHECK(seen.rays.work.shadows.out_of_reach == 1);
}

TEST_CASE("a black light, and one without a direction, cost no shadow ray in the whole scene") {
  Scene scene = still_life(diffuse(Rgb(0.5)), specular(Rgb(0.5), 9));
  const Rendered before = rendered_counting(scene, small(), InstructionSet::baseline, false);
  scene.lights.push_back(directional({0, 0, -1}, Rgb(0)));
  scene.lights.push_back(DirectionalLight{Rgb(1), Vec3(0)});
  const auto [needed, all] = needed_and_all(scene, small());
  CHECK(needed.image.rgb == before.image.rgb);
  CHECK(needed.rays.shadow == before.rays.shadow);
  CHECK(needed.rays.work.shadows.culled > 0);
  CHECK(all.rays.shadow > before.rays.shadow);
}

TEST_CASE("where no surface reflects light no light costs a shadow ray") {
  const auto [needed, all] =
      needed_and_all(still_life(emissive({1, 0, 0}), emissive(Rgb(0.5)) + reflective(Rgb(0.5))), small(2));
  CHECK(needed.rays.reflected > 0);
  CHECK(needed.rays.shadow == 0);
  CHECK(needed.rays.work.shadows.culled == needed.rays.work.shadows.total());
  CHECK(all.rays.shadow > 0);
}

TEST_CASE("each light of each surface is one shadow ray or spared for one reason") {
  Scene scene = still_life(diffuse({1, 0.5, 0}), emissive(Rgb(0.1)));
  surround(scene, {10, 20, 30});  // which counts the rays that hit nothing
  scene.lights.push_back(directional({0, 0, 1}, Rgb(0)));
  const auto [needed, all] = needed_and_all(scene, small());
  const std::uint64_t surfaces = pixels - needed.rays.work.surroundings;
  REQUIRE(surfaces > 100);
  CHECK(needed.rays.shadow + needed.rays.work.shadows.total() == 4 * surfaces);
  CHECK(needed.rays.work.shadows.culled == surfaces);
  CHECK(needed.rays.work.shadows.reflects_nothing > 0);
  CHECK(needed.rays.work.shadows.behind > 0);
  CHECK(all.rays.shadow == 4 * surfaces);
}

TEST_CASE("nothing is looked up around a scene without a cube map") {
  const Scene scene = still_life(diffuse(Rgb(0.5)), diffuse(Rgb(0.5)));
  const auto [needed, all] = needed_and_all(scene, small());
  CHECK(needed.rays.work.surroundings == 0);
  CHECK(all.rays.work.surroundings > 0);
  Scene surrounded = scene;
  surround(surrounded, {0, 0, 0});
  const Rendered black = rendered_counting(surrounded, small(), InstructionSet::baseline, false);
  CHECK(black.rays.work.surroundings == all.rays.work.surroundings);
  CHECK(black.image.rgb == needed.image.rgb);
}

TEST_CASE("a surface without specular colour takes no power of a highlight") {
  Material matt = diffuse(Rgb(0.5));
  matt.shininess = Rgb(20);
  const auto [needed, all] = needed_and_all(still_life(matt, matt), small());
  CHECK(needed.rays.work.highlights == 0);
  CHECK(all.rays.work.highlights > pixels);
  const auto shiny = needed_and_all(still_life(specular(Rgb(0.5), 20), matt), small());
  CHECK(shiny.needed.rays.work.highlights > 0);
  CHECK(shiny.needed.rays.work.highlights < shiny.all.rays.work.highlights);
}

TEST_CASE("a material without maps is not evaluated point by point, with the same bits where it is") {
  const Material odd_bits = diffuse({0.1, 0.7, 1 / 3.0}) + specular({0.3, 0.9, 1e-5}, 12.7);
  Scene scene = still_life(odd_bits, odd_bits);
  add(scene, front_triangle(), moved(-1, 1, 0), odd_bits);
  const auto [needed, all] = needed_and_all(scene, small());
  CHECK(needed.rays.work.maps == 0);
  // Every surface that a primary ray hits, and those that shadow rays do.
  CHECK(all.rays.work.maps > all.rays.primary - all.rays.work.surroundings);
  ShadingOptions everything;
  everything.model_everything = true;
  for (const double x : {-1.0, -0.6, 0.7}) {
    const Ray down = ray({x, 0.7, 5}, glm::normalize(Vec3(0, -0.1, -1)));
    CHECK(seen(scene, down, 2) == seen(scene, down, 2, everything));
  }
  MappedMaterial mapped;
  mapped.diffuse = 0;
  scene.textures.emplace_back(Image{1, 1, {200, 100, 50}});
  add(scene, Box{}, moved(1, 1, 1) * scaled(0.5), mapped);
  CHECK(needed_and_all(scene, small()).needed.rays.work.maps > 0);
}

TEST_CASE("a handful of objects is a list, and a hierarchy over them finds the same") {
  const Scene scene = wall(diffuse(Rgb(0.5)), {directional({0, 0, -1})});
  CHECK(SceneTree(scene).is_list());
  CHECK_FALSE(SceneTree(scene, 1, best_instruction_set(), true).is_list());
  CHECK(SceneTree(Scene(), 1, best_instruction_set(), true).is_list());  // there is nothing to sort
  needed_and_all(scene, small());
  needed_and_all(still_life(diffuse(Rgb(0.5)), specular(Rgb(1), 2)), small());
}

TEST_CASE("what is thrown away may be infinite or undefined, the picture stays finite") {
  Scene scene = still_life(diffuse(Rgb(0.5)), emissive(Rgb(0.25)));
  // Seen only by rays that are thrown away: behind the viewer.
  add(scene, Square{}, moved(0, 0, 9) * scaled(40), emissive(Rgb(1e308)) + ambient(Rgb(1e308)));
  scene.ambient = Rgb(1);
  const auto [needed, all] = needed_and_all(scene, small(2));
  CHECK(needed.non_finite.count == 0);
  CHECK(all.non_finite.count == 0);
  CHECK(all.rays.reflected > 0);
}

TEST_CASE("nothing is counted beside the rays unless it is asked for") {
  const Scene scene = still_life(specular(Rgb(0.5), 20), diffuse(Rgb(0.5)));
  for (const InstructionSet set : {InstructionSet::baseline, best_instruction_set()}) {
    RenderOptions options = small(2);
    options.instruction_set = set;
    const Rendered plain = rendered(scene, options);
    CHECK(plain.rays.work == WorkCounts{});
    const Rendered counted = rendered_counting(scene, options, set, false);
    CHECK(counted.rays.shadow == plain.rays.shadow);
    CHECK(!(counted.rays.work == WorkCounts{}));
  }
}
