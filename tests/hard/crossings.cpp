#include "tests/hard/crossings.hpp"

#include <algorithm>

namespace trace::hard {
namespace {

bool has(const FaceCorners& face, std::uint32_t point) {
  return std::find(face.begin(), face.end(), point) != face.end();
}

}  // namespace

Crossings::Crossings(const Mesh& mesh) : mesh_(mesh), faces_at_(mesh.points.size()) {
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::uint32_t point : mesh.faces[face]) faces_at_[point].push_back(face);
  }
}

Crossings::Count Crossings::count(const Ray& ray, std::span<const FaceHit> accepted) const {
  Count result;
  std::vector<std::uint32_t> open;
  for (const FaceHit& hit : accepted) open.push_back(hit.face);
  while (!open.empty()) {
    const std::uint32_t face = open.back();
    open.pop_back();
    const FaceCorners& f = mesh_.faces[face];
    const EdgeSigns signs = edge_signs(ray, mesh_.corners(face));
    if (!signs.inside()) {
      result.sound = false;
      continue;
    }
    if (signs.zeros() == 0) {
      ++result.crossings;
      continue;
    }
    // The corners on the zero edges: both of one edge, or the one that two edges share.
    std::vector<std::uint32_t> shared;
    if (signs.zeros() == 1) {
      const int opposite = signs.bc == 0 ? 0 : (signs.ca == 0 ? 1 : 2);
      shared = {f[(opposite + 1) % 3], f[(opposite + 2) % 3]};
    } else {
      shared = {signs.bc != 0 ? f[0] : (signs.ca != 0 ? f[1] : f[2])};
    }
    bool mixed = false;
    for (const std::uint32_t other : faces_at_[shared[0]]) {
      if (other == face || (shared.size() == 2 && !has(mesh_.faces[other], shared[1]))) continue;
      const EdgeSigns there = edge_signs(ray, mesh_.corners(other));
      const auto at = std::find(open.begin(), open.end(), other);
      if (there.inside() != (at != open.end())) result.sound = false;
      if (at != open.end()) open.erase(at);
      if (there.inside() && there.orientation() != signs.orientation()) mixed = true;
    }
    if (!mixed) ++result.crossings;
    if (mixed && shared.size() == 1) result.certain = false;
  }
  return result;
}

}  // namespace trace::hard
