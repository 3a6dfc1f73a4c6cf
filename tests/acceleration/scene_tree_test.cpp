// The hierarchy against testing every object.
#include "acceleration/scene_tree.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

struct Disagreements {
  int hits = 0;       // rays that met something
  int different = 0;  // another object, face or distance than every object in turn gives
  int shadows = 0;    // `occluded` differs from closest < limit
  std::string first;  // the first ray that differs
};

Disagreements compare(const Scene& scene, Random& random, int rays, double unit) {
  const SceneTree tree(scene);
  Disagreements result;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = random_ray(random, unit);
    for (const bool cull : {false, true}) {
      const Hit expected = closest_of_all(scene, ray, cull), found = tree.closest(ray, cull);
      const bool same = expected.t == found.t && (!expected || (expected.object == found.object &&
                                                                expected.local.part == found.local.part &&
                                                                expected.local.uv == found.local.uv));
      if (expected) ++result.hits;
      if (!same) {
        ++result.different;
        if (result.first.empty()) {
          result.first = "origin " + shown(ray.origin) + ", direction " + shown(ray.direction) +
                         ", expected " + std::to_string(expected.object) + " found " +
                         std::to_string(found.object);
        }
      }
      if (cull) continue;
      for (const double limit : {expected.t, expected.t * (1 + 1e-9), expected.t * 0.5, 1e300}) {
        if (tree.occluded(ray, limit) != (expected.t < limit)) ++result.shadows;
      }
    }
  }
  return result;
}

}  // namespace

TEST_CASE("the hierarchy finds what testing every object finds") {
  Random random(GENERATE(range(1u, 13u)));
  const int size = GENERATE(1, 3, 40);
  const Scene scene = random_scene(random, size);
  const Disagreements result = compare(scene, random, 400, 1);
  INFO(result.first);
  CHECK(result.different == 0);
  CHECK(result.shadows == 0);
}

TEST_CASE("random scenes are hit often enough to prove something") {
  Random random(1);
  CHECK(compare(random_scene(random, 40), random, 400, 1).hits > 200);
}

// Beyond 1e9 the step of a unit direction is lost in the rounding of the origin (ObjectRay), and t with it.
TEST_CASE("the hierarchy is right for tiny and for huge coordinates") {
  Random random(GENERATE(range(20u, 24u)));
  const double unit = GENERATE(1e-6, 1e6, 1e8);
  const Scene scene = random_scene(random, 30, unit);
  const Disagreements result = compare(scene, random, 300, unit);
  INFO(result.first);
  CHECK(result.hits > 30);
  CHECK(result.different == 0);
  CHECK(result.shadows == 0);
}

TEST_CASE("the hierarchy is right for a scene far from where coordinates are exact") {
  Random random(GENERATE(range(30u, 34u)));
  Scene scene;
  for (int i = 0; i < 50; ++i) {
    add(scene, Box{}, glm::translate(Mat4(1), Vec3(1e7) + random.on_grid(6, 0.5)), Material{});
  }
  const SceneTree tree(scene);
  int hits = 0, different = 0;
  for (int i = 0; i < 300; ++i) {
    Ray ray = random_ray(random);
    ray.origin += Vec3(1e7);
    const Hit expected = closest_of_all(scene, ray, false), found = tree.closest(ray, false);
    if (expected) ++hits;
    if (expected.t != found.t || expected.object != found.object) ++different;
  }
  CHECK(hits > 60);
  CHECK(different == 0);
}

TEST_CASE("an empty scene is missed") {
  const Scene scene;
  const SceneTree tree(scene);
  CHECK_FALSE(tree.closest({Vec3(0), Vec3(0, 0, -1)}, true));
  CHECK_FALSE(tree.occluded({Vec3(0), Vec3(0, 0, -1)}, 1e300));
}

TEST_CASE("a ray without a place or a direction is searched to an end") {
  Random random(40);
  const Scene scene = random_scene(random, 25);
  const SceneTree tree(scene);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(tree.closest({Vec3(0), Vec3(nan)}, true));
  for (const double bad : {nan, infinity, -infinity, 1e300}) {
    CHECK_FALSE(tree.closest({Vec3(bad), Vec3(nan)}, true));
    CHECK_FALSE(tree.closest({Vec3(bad), glm::normalize(Vec3(1))}, true));
    CHECK_FALSE(tree.occluded({Vec3(bad), glm::normalize(Vec3(1, -1, 1))}, 1));
  }
}

TEST_CASE("of coincident objects the first in the file is hit") {
  // More than fit one leaf, and in any order of the tree.
  Scene scene;
  for (int i = 0; i < 100; ++i) add(scene, Square{}, moved(0, 0, -1 - i % 4), Material{});
  const SceneTree tree(scene);
  CHECK(tree.closest({Vec3(0), Vec3(0, 0, -1)}, true).object == 0);
  CHECK(tree.closest({Vec3(0, 0, -9), Vec3(0, 0, 1)}, true).object == 3);
}

TEST_CASE("of coincident faces the first in the file is hit, culled ones aside") {
  Scene scene;
  Mesh mesh = front_triangle();
  mesh.faces.clear();
  for (int i = 0; i < 50; ++i) mesh.faces.push_back(i % 2 == 0 ? FaceCorners{0, 2, 1} : FaceCorners{0, 1, 2});
  add(scene, mesh, at_origin(), Material{});
  const SceneTree tree(scene);
  const Ray down{{0, 0, 3}, {0, 0, -1}};
  CHECK(tree.closest(down, false).local.part == 0);
  CHECK(tree.closest(down, true).local.part == 1);
  const Ray up{{0, 0, -3}, {0, 0, 1}};
  CHECK(tree.closest(up, true).local.part == 0);
}

TEST_CASE("a distance is one of the world, whatever the scale of the object") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, -10) * scaled(4), Material{});
  add(scene, front_triangle(), moved(0, 0, -5) * scaled(0.25), Material{});
  const SceneTree tree(scene);
  CHECK(tree.closest({Vec3(0, 1, 0), Vec3(0, 0, -1)}, true).t == about(8));
  CHECK(tree.closest({Vec3(0), Vec3(0, 0, -1)}, true).t == about(5));
  CHECK(tree.occluded({Vec3(0), Vec3(0, 0, -1)}, 5.001));
  CHECK_FALSE(tree.occluded({Vec3(0), Vec3(0, 0, -1)}, 4.999));
}

TEST_CASE("culling leaves out faces seen from behind, also of mirrored meshes, and occlusion never does") {
  Scene scene;
  add(scene, GENERATE(true, false) ? back_triangle() : front_triangle(), scaled(1, 1, GENERATE(1.0, -1.0)),
      Material{});
  const Vec3 normal = scene.frames[0].world_normal(face_normal(scene.meshes[0].geometry.triangle(0)));
  const SceneTree tree(scene);
  const Ray down{{0, 0, 3}, {0, 0, -1}};
  CHECK(static_cast<bool>(tree.closest(down, true)) == (normal.z > 0));
  CHECK(tree.closest(down, false));
  CHECK(tree.occluded(down, 10));
}
