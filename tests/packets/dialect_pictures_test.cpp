// Pictures of the dialects' shapes by packets against those of single rays.
#include <catch2/catch.hpp>

#include "tests/support/scene_endless.hpp"
#include "tests/support/scene_picture.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Every shape once with a map, one that mirrors, one of glass, over a plane.
Scene show_case() {
  Scene scene;
  scene.camera = usual_camera();
  scene.camera.eye = {0, 1, 9};
  scene.ambient = Rgb(0.25);
  scene.lights.emplace_back(directional({-1, -2, -1.5}));
  Image squares{8, 8, {}};
  for (int i = 0; i < 64; ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      squares.rgb.push_back(static_cast<std::uint8_t>((i * 37 + channel * 90) % 256));
    }
  }
  scene.textures.emplace_back(squares);
  MappedMaterial map;
  map.values = diffuse(Rgb(0.5)) + ambient(Rgb(1)) + specular(Rgb(0.5), 20);
  map.diffuse = map.ambient = 0;
  Bounds above = Bounds::everything();
  above.min.y = 0;
  above.max.y = 1;
  const Quadric bowl({1, 0, 1, 0, 0, 0, 0, -1, 0, 0}, above,
                     {Vec3(-1.001, 0, -1.001), Vec3(1.001, 1, 1.001)});
  const std::vector<Shape> shapes{Sphere{}, Cylinder{}, Cone(1, 0.5, 1, true), Tube{}, Torus(0.8, 0.3), bowl};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Mat4 place = moved(-3.5 + 1.4 * static_cast<double>(i), 0.3 * static_cast<double>(i % 2), 0) *
                       turned(0.7 * static_cast<double>(i), 1, 2, 0.5) * scaled(0.7);
    add(scene, shapes[i], place, map);
  }
  add(scene, Torus(1, 0.4), moved(-1, 2, -1), reflective(Rgb(0.8)) + diffuse(Rgb(0.1)));
  add(scene, Torus(1, 0.4), moved(2, 2, 1) * turned(1, 1, 0, 0), transmissive(Rgb(0.9), 1.4));
  map.values.reflective = Rgb(0.3);
  add(scene, Plane(Vec3(0, -1, 0), Vec3(0, 1, 0)), at_origin(), map);
  add(scene, Quadric({1, -1, -1, 0, 0, 0, 0, 0, 0, -1}), moved(0, 0, -6), diffuse(Rgb(0.2, 0.6, 0.4)));
  return scene;
}

}  // namespace

TEST_CASE(
    "a picture of the dialects' shapes and of maps on curved surfaces is the same with every instruction "
    "set") {
  const Scene scene = show_case();
  RenderOptions options;
  options.width = 80;
  options.depth = 3;
  options.threads = 1;
  const bool everything = GENERATE(false, true);
  options.shading.model_everything = everything;
  options.instruction_set = InstructionSet::baseline;
  const Rendered expected = rendered(scene, options);
  for (const auto set : {InstructionSet::sse4, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    options.instruction_set = set;
    const Rendered found = rendered(scene, options);
    CHECK(found.image.rgb == expected.image.rgb);
    CHECK(found.rays == expected.rays);
  }
}
