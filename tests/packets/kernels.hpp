// The packet kernels as functions on rays one after the other, for each set of instructions.
#pragma once

#include <span>
#include <vector>

#include "acceleration/scene_tree.hpp"
#include "instruction_set/instruction_set.hpp"

namespace trace::test {

// What the kernel of a shape says of a ray.
struct ShapeAnswer {
  bool unusual = false, found = false;
  LocalHit hit;
};

struct ObjectRayAnswer {
  bool unusual = false;
  Ray ray;
  double scale = 0;
};

struct NormalAnswer {
  bool unusual = false;
  Vec3 normal{0};
};

// All take up to `lanes` rays (points, normals) as one packet. Bit i of `active` is ray i; answers for rays
// that are not active do not count.
struct PacketKernels {
  InstructionSet set;
  std::size_t lanes;

  // `shape` is not a mesh.
  std::vector<ShapeAnswer> (*intersect)(const Shape& shape, std::span<const Ray> rays, unsigned active);
  // With the rounding of its formula, as shading/surface.cpp has it.
  std::vector<double> (*distance)(const Shape& shape, std::span<const Vec3> points,
                                  std::span<const Vec3> normals);
  unsigned (*hit_bounds)(const Bounds& bounds, std::span<const Ray> rays, unsigned active);
  std::vector<ObjectRayAnswer> (*object_rays)(const Frame& frame, std::span<const Ray> rays);
  std::vector<NormalAnswer> (*world_normals)(const Frame& frame, std::span<const Vec3> normals);
  std::vector<Hit> (*closest)(const Scene& scene, const SceneTree& tree, std::span<const Ray> rays,
                              unsigned active, bool cull);
  unsigned (*occluded)(const Scene& scene, const SceneTree& tree, std::span<const Ray> rays, unsigned active,
                       std::span<const double> limits);
};

// Of the sets that this machine has; empty where it has none.
std::vector<PacketKernels> packet_kernels();

}  // namespace trace::test
