// Hierarchies find what trying everything finds.
#include "acceleration/scene_tree.hpp"

#include <ostream>

#include "tests/properties/generators.hpp"
#include "tests/properties/property.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("the hierarchy of a scene answers every ray as trying every object does") {
  holds(
      [] {
        const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1u << 30).as("seed");
        const int size = *rc::gen::inRange(1, 60).as("objects");
        const int rays = *rc::gen::inRange(1, 100).as("rays");
        Random random(seed);
        const Scene scene = random_scene(random, size);
        const SceneTree tree(scene);
        for (int i = 0; i < rays; ++i) {
          const Ray ray = random_ray(random);
          const bool cull = random.below(2) == 0;
          const Hit found = tree.closest(ray, cull), expected = closest_of_all(scene, ray, cull);
          RC_ASSERT(found.t == expected.t);
          if (!expected) continue;
          RC_ASSERT(found.object == expected.object);
          RC_ASSERT(found.local.part == expected.local.part);
        }
      },
      150);
}

TEST_CASE("the hierarchy of a mesh answers every ray as its faces one by one do") {
  holds(
      [] {
        Mesh mesh;
        for (int points = *rc::gen::inRange(3, 40).as("points"); points > 0; --points)
          mesh.points.push_back((*place()).at);
        const auto corner =
            rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(mesh.points.size()));
        for (int faces = *rc::gen::inRange(1, 60).as("faces"); faces > 0; --faces) {
          const std::uint32_t corners[] = {*corner, *corner, *corner};
          add_polygon(mesh, corners, 3);
        }
        const Ray ray{(*place()).at, (*heading()).along};
        const double no_limit = std::numeric_limits<double>::infinity();
        LocalHit expected;
        bool any = false;
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
          Mesh alone;
          alone.points = mesh.points;
          alone.faces = {mesh.faces[face]};
          LocalHit hit;
          if (!MeshTree(alone).closest(ray, no_limit, false, hit) || (any && hit.t >= expected.t)) continue;
          expected = hit;
          expected.part = face;
          any = true;
        }
        LocalHit found;
        const MeshTree tree(mesh);
        RC_ASSERT(tree.closest(ray, no_limit, false, found) == any);
        RC_PRE(any);
        RC_ASSERT(found.t == expected.t);
        RC_ASSERT(found.part == expected.part);
        RC_ASSERT(found.uv == expected.uv);
      },
      200);
}
