// Maps of heights and of normals.
#include "scene/surface_maps.hpp"
#include "shading/surface.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// 257 texels wide: grey rises along u from 0 to 1 (and v does nothing), or along v.
Texture ramp(bool along_v) {
  Image image{257, 257, {}};
  for (int y = 256; y >= 0; --y) {
    for (int x = 0; x < 257; ++x) {
      const auto grey = static_cast<std::uint8_t>(std::min(along_v ? y : x, 255));
      image.rgb.insert(image.rgb.end(), {grey, grey, grey});
    }
  }
  return Texture(std::move(image));
}

Texture plain(std::array<std::uint8_t, 3> color) {
  return Texture(Image{1, 1, {color[0], color[1], color[2]}});
}

Scene bumped(const Shape& shape, const Mat4& place, const Texture& heights) {
  Scene scene;
  scene.textures.push_back(heights);
  MappedMaterial material;
  material.bump = 0;
  add(scene, shape, place, material);
  return scene;
}

Scene with_normals(const Shape& shape, const Mat4& place, const Texture& normals) {
  Scene scene = bumped(shape, place, normals);
  std::swap(scene.materials[0].bump, scene.materials[0].normal);
  return scene;
}

Vec3 normal_at(const Scene& scene, const Ray& ray) {
  const SceneTree tree(scene);
  const Hit hit = tree.closest(ray, false);
  REQUIRE(hit);
  return Surface(scene, ray, hit, true).normal();
}

// Of the ramp: F changes by 256 / 255 over the picture.
const double slope = bump_height * 256 / 255;

}  // namespace

TEST_CASE("a bump map turns the normal down its slope, by a tenth of the picture's edge") {
  const double size = GENERATE(1.0, 7.0);  // it is the shape that counts, not the size
  const Scene along_u = bumped(Square{}, scaled(size, size, 1), ramp(false));
  CHECK(normal_at(along_u, from_front()) == near(glm::normalize(Vec3(-slope, 0, 1)), 1e-9));
  const Scene along_v = bumped(Square{}, scaled(size, size, 1), ramp(true));
  CHECK(normal_at(along_v, from_front()) == near(glm::normalize(Vec3(0, -slope, 1)), 1e-9));
  const Scene from_behind = bumped(Square{}, scaled(size, size, 1), ramp(false));
  CHECK(normal_at(from_behind, ray({0, 0, -5}, {0, 0, 1})) ==
        near(glm::normalize(Vec3(-slope, 0, -1)), 1e-9));
}

TEST_CASE("a bump map of one height, or on a surface without tangents, leaves the normal as it is") {
  const Scene even = bumped(Square{}, at_origin(), plain({9, 9, 9}));
  CHECK(normal_at(even, from_front()) == Vec3(0, 0, 1));
  Mesh mesh = front_triangle();
  mesh.coordinates = {{0, 0}, {0.5, 0.5}, {1, 1}};
  Scene scene;
  scene.textures.push_back(ramp(false));
  add(scene, mesh, at_origin(), Material{});
  scene.materials[0].bump = 0;
  CHECK(normal_at(scene, from_front()) == Vec3(0, 0, 1));
}

TEST_CASE("each face of a box is bumped along its own texture coordinates") {
  const Scene scene = bumped(Box{}, at_origin(), ramp(false));
  const auto seen_from = [&](const Vec3& eye) { return normal_at(scene, {eye, glm::normalize(-eye)}); };
  // u grows along the lower axis of a face, and on -x, -y and -z against it.
  CHECK(seen_from({5, 0, 0}) == near(glm::normalize(Vec3(1, -slope, 0)), 1e-9));
  CHECK(seen_from({-5, 0, 0}) == near(glm::normalize(Vec3(-1, slope, 0)), 1e-9));
  CHECK(seen_from({0, 0, 5}) == near(glm::normalize(Vec3(-slope, 0, 1)), 1e-9));
  CHECK(seen_from({0, 0, -5}) == near(glm::normalize(Vec3(slope, 0, -1)), 1e-9));
  CHECK(seen_from({0, 5, 0}) == near(glm::normalize(Vec3(-slope, 1, 0)), 1e-9));
}

TEST_CASE("a normal map's blue is the normal, red goes with u, green with v, turned with the object") {
  const Mat4 place = turned(0.7, 0, 0, 1);
  CHECK(normal_at(with_normals(Square{}, place, plain({128, 128, 255})), from_front()) ==
        near(Vec3(0, 0, 1), 0.01));
  const Vec3 red(std::cos(0.7), std::sin(0.7), 0), green(-std::sin(0.7), std::cos(0.7), 0);
  const double tilt = 191.0 / 255 * 2 - 1, flat = 128.0 / 255 * 2 - 1;
  CHECK(normal_at(with_normals(Square{}, place, plain({191, 128, 255})), from_front()) ==
        near(glm::normalize(tilt * red + flat * green + Vec3(0, 0, 1)), 1e-9));
  CHECK(normal_at(with_normals(Square{}, place, plain({128, 191, 255})), from_front()) ==
        near(glm::normalize(flat * red + tilt * green + Vec3(0, 0, 1)), 1e-9));
}

TEST_CASE("a mesh is bumped as the square of the same texture coordinates") {
  Mesh mesh;
  mesh.points = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}};
  mesh.coordinates = {{0, 0}, {1, 0}, {1, 1}};
  mesh.faces = {{0, 1, 2}};
  Scene scene;
  scene.textures.push_back(ramp(false));
  add(scene, mesh, at_origin(), Material{});
  scene.materials[0].bump = 0;
  const Ray ray{{0.1, -0.2, 5}, {0, 0, -1}};
  CHECK(normal_at(scene, ray) == near(normal_at(bumped(Square{}, at_origin(), ramp(false)), ray), 1e-9));
}

TEST_CASE("surfaces without texture coordinates are bumped along the axis they face") {
  const Shape shape = GENERATE(Shape(Sphere{}), Shape(Cylinder{}));
  const Scene scene = bumped(shape, at_origin(), ramp(false));
  const Ray ray{{0.05, 0.05, 5}, {0, 0, -1}};
  const Vec3 bare = normal_at(
      [&] {
        Scene s;
        add(s, shape, at_origin(), Material{});
        return s;
      }(),
      ray);
  const Vec3 turned_normal = normal_at(scene, ray);
  CHECK(turned_normal != bare);
  CHECK(std::abs(glm::length(turned_normal) - 1) < 1e-12);
  CHECK(glm::dot(turned_normal, bare) > 0.9);
}

TEST_CASE("a turned normal keeps its side of the ray, and mirrors no ray into the surface") {
  Random random(5);
  Image noise{64, 64, {}};
  for (int i = 0; i < 64 * 64 * 3; ++i) noise.rgb.push_back(static_cast<std::uint8_t>(i * 7919 % 256));
  for (const bool heights : {false, true}) {
    const Scene scene = heights ? bumped(Box{}, at_origin(), Texture(noise))
                                : with_normals(Box{}, at_origin(), Texture(noise));
    Scene bare;
    add(bare, Box{}, at_origin(), Material{});
    const SceneTree tree(scene);
    int hits = 0;
    for (int i = 0; i < 2'000; ++i) {
      const Ray ray = random_ray(random);
      const Hit hit = tree.closest(ray, false);
      if (!hit) continue;
      ++hits;
      const Vec3 n = Surface(bare, ray, hit, true).normal(), turned = Surface(scene, ray, hit, true).normal();
      REQUIRE(is_finite(turned));
      CHECK(std::abs(glm::length(turned) - 1) < 1e-9);
      const double side = glm::dot(n, ray.direction);
      CHECK(side * glm::dot(turned, ray.direction) >= 0);
      const Vec3 mirrored = ray.direction - 2 * glm::dot(ray.direction, turned) * turned;
      CHECK(side * glm::dot(mirrored, n) <= 0);
    }
    CHECK(hits > 20);
  }
}

TEST_CASE("light falls on a bumped square by its turned normal") {
  Scene scene = bumped(Square{}, at_origin(), ramp(false));
  scene.materials[0].values.diffuse = Rgb(1);
  scene.lights.push_back(directional({0, 0, -1}));
  CHECK(seen(scene).x == about(1 / std::sqrt(1 + slope * slope)));
}
