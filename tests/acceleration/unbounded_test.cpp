// Objects without an end beside the hierarchy.
#include "acceleration/scene_tree.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_endless.hpp"

using namespace trace;
using namespace trace::test;

namespace {

int differences(const Scene& scene, Random& random, double unit, int& hits) {
  const SceneTree tree(scene);
  int different = 0;
  for (int i = 0; i < 400; ++i) {
    const Ray ray = random_ray(random, unit);
    const Hit expected = closest_of_all(scene, ray, false), found = tree.closest(ray, false);
    if (expected) ++hits;
    if (expected.t != found.t || (expected && expected.object != found.object)) ++different;
    for (const double limit : {expected.t, expected.t * (1 + 1e-9), expected.t * 0.5, 1e300}) {
      if (tree.occluded(ray, limit) != (expected.t < limit)) ++different;
    }
  }
  return different;
}

}  // namespace

TEST_CASE("a hierarchy with objects without an end beside it finds what testing every object finds") {
  Random random(GENERATE(range(50u, 56u)));
  const int size = GENERATE(1, 3, 4, 40);
  const double unit = GENERATE(1.0, 1e-6, 1e6);
  int hits = 0;
  CHECK(differences(endless_scene(random, size, unit), random, unit, hits) == 0);
  CHECK(hits > 100);
}

TEST_CASE("of coincident objects the first in the file is hit, with an end or without") {
  for (const int first : {0, 5, 9}) {
    Scene scene;
    for (int i = 0; i < 10; ++i) {
      if (i == first) {
        add(scene, Plane(Vec3(0), Vec3(0, 0, 1)), moved(0, 0, -1), Material{});
      } else {
        add(scene, Square{}, moved(0, 0, -1), Material{});
      }
    }
    const SceneTree tree(scene);
    CHECK(tree.closest({Vec3(0), Vec3(0, 0, -1)}, true).object == 0);
    CHECK(tree.closest({Vec3(7, 0, 0), Vec3(0, 0, -1)}, true).object == static_cast<std::uint32_t>(first));
  }
}

TEST_CASE("a scene of objects without an end alone is searched, sorted or not") {
  Scene scene;
  for (int i = 0; i < 8; ++i) add(scene, Plane(Vec3(0), Vec3(0, 0, 1)), moved(0, 0, -2 - i), Material{});
  for (const bool sorted : {false, true}) {
    const SceneTree tree(scene, 1, best_instruction_set(), sorted);
    const Hit hit = tree.closest({Vec3(0), Vec3(0, 0, -1)}, true);
    CHECK((hit.t == 2 && hit.object == 0));
    CHECK(tree.occluded({Vec3(0), Vec3(0, 0, -1)}, 2.001));
    CHECK_FALSE(tree.occluded({Vec3(0), Vec3(0, 0, -1)}, 2));
    CHECK_FALSE(tree.closest({Vec3(0), Vec3(0, 0, 1)}, true));
  }
}

TEST_CASE("a hierarchy is that of the objects with an end alone") {
  Random random(60);
  Scene scene = random_scene(random, 40);
  const SceneTree without(scene);
  add(scene, Plane(Vec3(0), Vec3(0, 1, 0)), moved(0, -3, 0), Material{});
  const SceneTree with(scene);
  CHECK(with.bvh().nodes.size() == without.bvh().nodes.size());
  CHECK(with.bvh().centre == without.bvh().centre);
  CHECK((with.unbounded() == 1 && without.unbounded() == 0));
}
