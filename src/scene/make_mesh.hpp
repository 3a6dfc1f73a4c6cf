// From a mesh's lists to triangles.
#pragma once

#include "geometry/mesh.hpp"
#include "parser/description.hpp"

namespace trace {

// Polygons become fans, faces with two equal corners are dropped, and normals are generated where the mesh
// asks for them, of unit length if `unit_normals` says so. Each list is released as soon as it is taken over,
// so that a large mesh is not held twice.
Mesh make_mesh(parser::Mesh said, bool unit_normals = false);

}  // namespace trace
