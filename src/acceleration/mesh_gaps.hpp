// Where a ray crosses a mesh between two faces that both miss it by rounding.
//
// Seen as the course's renderer decides, such places are pinholes. A mesh that is closed must not have them;
// but the edge of a mesh, and an edge at which it turns away from the ray, may be touched or missed. So of
// the triangles that are crossed exactly though the course's form misses them, one counts where the ray is
// strictly within its edges, and one whose edge or corner the ray meets exactly only together with another
// that faces the same way there: between the two the surface goes on.
#pragma once

#include <vector>

#include "geometry/triangle.hpp"

namespace trace {

struct MeshGap {
  TriangleHit hit;
  std::uint32_t face;
  bool on_edge;
  bool from_behind;  // the face is seen from behind
};

// A gap further along a shadow ray than this part of the way to the light hides nothing: it is at the place
// of the light, which may lie in a corner of the mesh. The plain form's t tells so much of faces down to a
// thousandth of the way, seen at a degree or more (64 u times size over height), without asking exactly.
inline constexpr double gaps_before_light = 1 - 0x1p-32;

class MeshGaps {
 public:
  void add(const MeshGap& gap) { gaps_.push_back(gap); }

  // The nearest that counts, of those at the same t the first in the file; null for none.
  const MeshGap* nearest() const;

 private:
  bool counts(const MeshGap& gap) const;

  std::vector<MeshGap> gaps_;  // hardly ever any
};

}  // namespace trace
