// Rays that run within the boundary of an object: a coordinate of the ray is exactly where the object ends,
// up to the rounding of the object's place. The exact formulas may say hit where a box taken too literally
// says miss.
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

struct Count {
  int hits = 0, lost = 0;
};

// Rays along the edge of a box or of a mesh, which is moved so that the edge comes to lie at x = 0 or next to
// it.
Count along_edges(const std::vector<double>& d_x) {
  Count count;
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const double size = random.between(0.1, 3), there = random.between(-3, 3);
    const Mat4 place = moved(there, 0, 0) * moved(0.5 * size - there, 0, -5) * scaled(size);
    Scene scene;
    if (i % 2 == 0) {
      add(scene, Box{}, place, Material{});
    } else {
      Mesh square;
      square.points = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
      square.faces = {{0, 1, 2}, {0, 2, 3}};
      add(scene, square, place, Material{});
    }
    const SceneTree tree(scene);
    for (const double dx : d_x) {
      const Ray ray{{0, random.between(-0.04, 0.04), 3},
                    glm::normalize(Vec3(dx, random.between(-0.001, 0.001), -1))};
      const Hit expected = closest_of_all(scene, ray, false);
      if (expected) ++count.hits;
      if (expected.t != tree.closest(ray, false).t) ++count.lost;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("no hit is lost on an edge that a ray runs along") {
  const Count count = along_edges({0.0, -0.0});
  CHECK(count.hits > 2000);
  CHECK(count.lost == 0);
}

TEST_CASE("no hit is lost on an edge that a ray almost runs along") {
  const Count count = along_edges({1e-17, -1e-17, 3e-18, -1e-20});
  CHECK(count.hits > 2000);
  CHECK(count.lost == 0);
}
