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

}  // namespace trace
