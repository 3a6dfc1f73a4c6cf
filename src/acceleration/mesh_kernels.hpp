// Searches of a mesh for single rays, compiled for each set of vector instructions.
#pragma once

#include "acceleration/mesh_search.hpp"
#include "instruction_set/instruction_set.hpp"

namespace trace {

// Hand the search every face that the ray may meet within `limit`, near ones first as far as boxes tell,
// until it ends the search.
struct MeshKernels {
  void (*nearest)(const MeshTree& tree, const Ray& ray, double limit, NearestFace& search);
  void (*any)(const MeshTree& tree, const Ray& ray, double limit, AnyFace& search);
};

const MeshKernels& mesh_kernels(InstructionSet set);

// The same without vectors wider than every processor's, for any ray.
template <class Search>
void one_by_one(const MeshTree& tree, const BvhRay& ray, double limit, Search& search) {
  traverse(tree.bvh(), ray, limit, [&](std::uint32_t first, std::uint32_t count, double current) {
    for (std::uint32_t i = first; i < first + count && current >= 0; ++i) current = search.test(i, current);
    return current;
  });
}

}  // namespace trace
