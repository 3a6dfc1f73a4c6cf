// Searches of a mesh with every set of vector instructions that the machine has.
#include <bit>
#include <catch2/catch.hpp>

#include "acceleration/mesh_tree.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Faces between random points: many cross, some are thin, and those on the grid share edges and planes.
Mesh random_mesh(Random& random, std::uint32_t faces, bool on_grid, double unit) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < faces / 2 + 3; ++i) {
    mesh.points.push_back(unit * (on_grid ? random.on_grid(6, 0.5) : random.in_cube(3)));
  }
  const auto points = static_cast<std::uint32_t>(mesh.points.size());
  while (mesh.faces.size() < faces) {
    const std::uint32_t corners[] = {random.below(points), random.below(points), random.below(points)};
    add_polygon(mesh, corners, 3);
  }
  return mesh;
}

std::uint64_t bits(double v) {
  return std::bit_cast<std::uint64_t>(v);
}

}  // namespace

TEST_CASE("every set of instructions finds what testing every face finds, bit for bit") {
  const int set = GENERATE(0, 1, 2, 3);
  if (static_cast<InstructionSet>(set) > best_instruction_set()) return;
  const bool on_grid = GENERATE(false, true);
  // Beyond some units numbers leave what the filter of triangles can tell, and then the range of floats.
  const double unit = GENERATE(1.0, 1e-8, 0x1p-40, 0x1p45, 0x1p140);
  Random random(static_cast<std::uint32_t>(7 + set));
  const Mesh mesh = random_mesh(random, 120, on_grid, unit);
  const MeshTree tree(mesh, static_cast<InstructionSet>(set));
  int met = 0;
  for (int i = 0; i < 400; ++i) {
    const Ray ray = random_ray(random, unit);
    const bool cull = random.below(2) == 0;
    LocalHit truth, found;
    const bool expected = nearest_face(mesh, ray, cull, truth);
    REQUIRE(tree.closest(ray, infinity, cull, found) == expected);
    if (!expected) {
      if (!cull) REQUIRE_FALSE(tree.occludes(ray, 1, infinity));
      continue;
    }
    ++met;
    REQUIRE(found.part == truth.part);
    REQUIRE(bits(found.t) == bits(truth.t));
    REQUIRE(bits(found.uv.x) == bits(truth.uv.x));
    REQUIRE(bits(found.uv.y) == bits(truth.uv.y));
    if (cull || truth.is_gap) continue;
    CHECK(tree.occludes(ray, 1, truth.t * (1 + 0x1p-50)));
    CHECK_FALSE(tree.occludes(ray, 1, truth.t * (1 - 0x1p-30)));
  }
  CHECK(met > 50);
}

TEST_CASE("a ray from beyond the range of floats, or along an undefined direction, ends") {
  const int set = GENERATE(0, 1, 2, 3);
  if (static_cast<InstructionSet>(set) > best_instruction_set()) return;
  Random random(5);
  const Mesh mesh = random_mesh(random, 40, false, 1);
  const MeshTree tree(mesh, static_cast<InstructionSet>(set));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  LocalHit hit;
  CHECK_FALSE(tree.closest({Vec3(1e300, 0, 0), Vec3(1, 0, 0)}, infinity, false, hit));
  tree.closest({Vec3(1e300, 1e300, 0), Vec3(-1, 0, 0)}, infinity, false, hit);
  tree.closest({Vec3(0), Vec3(nan)}, infinity, false, hit);
  tree.occludes({Vec3(nan, 0, 0), Vec3(0, 0, 1)}, 1, infinity);
}

TEST_CASE("the tree of a mesh does not depend on the number of threads") {
  Random random(11);
  const Mesh mesh = random_mesh(random, 30'000, false, 1);
  ThreadBudget one(1), four(4);
  const MeshTree a(mesh, best_instruction_set(), one), b(mesh, best_instruction_set(), four);
  REQUIRE(a.bvh().nodes.size() == b.bvh().nodes.size());
  for (std::size_t i = 0; i < a.bvh().nodes.size(); ++i) {
    const BvhNode &p = a.bvh().nodes[i], &q = b.bvh().nodes[i];
    for (int child = 0; child < bvh_width; ++child) {
      REQUIRE(p.child[child] == q.child[child]);
      REQUIRE(p.count[child] == q.count[child]);
      for (int axis = 0; axis < 3; ++axis) {
        REQUIRE(p.low[axis][child] == q.low[axis][child]);
        REQUIRE(p.high[axis][child] == q.high[axis][child]);
      }
    }
  }
  for (std::size_t i = 0; i < a.faces().size(); ++i) REQUIRE(a.faces()[i].face == b.faces()[i].face);
}
