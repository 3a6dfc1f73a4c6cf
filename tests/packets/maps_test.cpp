// Maps in packets: the same bits as of single rays.
#include <catch2/catch.hpp>

#include "shading/surface.hpp"
#include "tests/support/scene_picture.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Texture noisy_picture(int seed) {
  Image image{31, 17, {}};
  for (int i = 0; i < 31 * 17 * 3; ++i)
    image.rgb.push_back(static_cast<std::uint8_t>((i + seed) * 7919 % 251));
  return Texture(std::move(image));
}

// Boxes, squares, spheres, cylinders and meshes with and without texture coordinates, with all kinds of maps,
// some of which mirror.
Scene mapped_scene() {
  Random random(11);
  Scene scene;
  SolidPattern marble;
  marble.frequency = 5;
  marble.depth = 3;
  const Texture first = noisy_picture(0), second = noisy_picture(5);
  scene.textures = {first, second, Texture(first, second, 0.4), Texture(marble)};
  scene.camera = usual_camera();
  scene.ambient = Rgb(0.2);
  scene.lights.push_back(directional({-0.5, -0.7, -1}));
  scene.lights.push_back(PointLight{Rgb(1), {1, 2, 4}});
  Mesh mesh = front_triangle();
  mesh.points.push_back({0.5, 0.3, 0.5});
  mesh.faces.push_back({0, 3, 2});
  mesh.coordinates = {{0, 0}, {2.5, 0.1}, {0.3, -1}, {0.7, 0.9}};
  Mesh smooth = mesh;
  generate_normals(smooth);
  for (int i = 0; i < 40; ++i) {
    const Mat4 place =
        glm::translate(Mat4(1), random.in_cube(1.5)) * turned(i, 1, 2, 3) * scaled(0.4, 0.5, 0.6);
    MappedMaterial material;
    material.values.diffuse = Rgb(0.5, 0.6, 0.7);
    material.values.ambient = Rgb(0.3);
    if (i % 3 == 0) material.values.reflective = Rgb(0.4);
    if (i % 7 == 0) material.values.transmissive = Rgb(0.3);
    if (i % 2 == 0) material.bump = i % 4 == 0 ? 0 : 1;
    if (i % 5 == 0) material.normal = 1;
    if (i % 8 < 5) material.diffuse = i % 4;
    if (i % 6 == 1) material.ambient = 2;
    switch (i % 6) {
      case 0:
        add(scene, Box{}, place, material);
        break;
      case 1:
        add(scene, Square{}, place, material);
        break;
      case 2:
        add(scene, Sphere{}, place, material);
        break;
      case 3:
        add(scene, Cylinder{}, place, material);
        break;
      default:
        add(scene, i % 6 == 4 ? mesh : smooth, place, Material{});
        scene.materials.back() = material;
    }
    scene.has_transmissive_objects |= material.values.transmits();
  }
  return scene;
}

}  // namespace

TEST_CASE("maps of every kind have the same pixels and rays in packets as by single rays") {
  const Scene scene = mapped_scene();
  RenderOptions options;
  options.width = 96;
  options.depth = 3;
  options.threads = 1;
  options.shading.backface_culling = false;
  options.instruction_set = InstructionSet::baseline;
  const Rendered single = rendered(scene, options);
  CHECK(single.rays.reflected > 0);
  for (const auto set : {InstructionSet::sse4, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    options.instruction_set = set;
    const Rendered packets = rendered(scene, options);
    CHECK(packets.image.rgb == single.image.rgb);
    CHECK(packets.rays == single.rays);
  }
}
