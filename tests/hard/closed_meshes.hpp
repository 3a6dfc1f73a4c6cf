// Closed meshes to look at from inside. Faces are counter-clockwise from outside.
#pragma once

#include "geometry/mesh.hpp"

namespace trace::hard {

// Rings of latitude around the z axis, with one point at each pole.
Mesh sphere_mesh(int rings, int sectors);

// As sphere_mesh, but each meridian has a twin `apart` radians away, so that every other face is a sliver.
Mesh sliver_sphere_mesh(int rings, int sectors, double apart);

// Around the z axis, of radius 1, the tube of radius 0.5.
Mesh torus_mesh(int sectors, int sides);

// Two cones base to base: `sectors` triangles meet in either tip.
Mesh double_cone_mesh(int sectors);

// Strictly convex, of 20 equal faces.
Mesh icosahedron_mesh();

// Points times `scale`, then moved; each coordinate rounds as it may.
Mesh placed(Mesh mesh, const Vec3& scale, const Vec3& offset);

}  // namespace trace::hard
