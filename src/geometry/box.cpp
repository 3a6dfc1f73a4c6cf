#include "geometry/box.hpp"

#include <algorithm>

#include "geometry/rounding.hpp"

namespace trace {
namespace {

// Where two faces meet, rounding can put the hit beyond the edge of both, and none is found. But a ray that
// is between all three pairs of planes for longer than the rounding of both ends, two roundings each,
// certainly crosses the box: by the face where it comes in, or out if it starts inside. -1 for none.
int face_across(const Ray& ray, double& t) {
  double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
  int in = 0, out = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (std::abs(o) > 0.5) return -1;
      continue;
    }
    const double near = d > 0 ? -0.5 : 0.5;
    if ((near - o) / d > enter) {
      enter = (near - o) / d;
      in = d > 0 ? axis : axis + 3;
    }
    if ((-near - o) / d < leave) {
      leave = (-near - o) / d;
      out = d > 0 ? axis + 3 : axis;
    }
  }
  if (!(leave - enter > gamma(4) * (std::abs(enter) + std::abs(leave)))) return -1;
  const auto is_ahead = [&](int face, double at) {
    return at > ray.least_t && std::abs(face / 3 - 0.5 - ray.origin[face % 3]) > ray.origin_error;
  };
  t = is_ahead(in, enter) ? enter : leave;
  if (t == enter) return in;
  return is_ahead(out, leave) ? out : -1;
}

}  // namespace

bool Box::intersect(const Ray& ray, LocalHit& hit) const {
  double best = std::numeric_limits<double>::infinity();
  int best_face = -1;
  for (int face = 0; face < 6; ++face) {
    const int axis = face % 3;
    if (ray.direction[axis] == 0) continue;
    const double plane = face / 3 - 0.5;
    const double t = (plane - ray.origin[axis]) / ray.direction[axis];
    if (!(t > ray.least_t && t < best) || std::abs(plane - ray.origin[axis]) <= ray.origin_error) continue;
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double a = ray.origin[next] + t * ray.direction[next];
    const double b = ray.origin[last] + t * ray.direction[last];
    if (a >= -0.5 && a <= 0.5 && b >= -0.5 && b <= 0.5) {
      best = t;
      best_face = face;
    }
  }
  if (best_face < 0) {
    best_face = face_across(ray, best);
    if (best_face < 0) return false;
    hit.is_gap = true;
  }

  const int axis = best_face % 3;
  const int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  const bool min_face = best_face < 3;
  const Vec3 p = ray.at(best);
  hit.t = best;
  hit.normal = Vec3(0);
  hit.normal[axis] = min_face ? -1 : 1;
  hit.uv = Vec2(min_face ? 0.5 - p[low] : 0.5 + p[low], 0.5 + p[high]);
  return true;
}

double Box::distance(const Vec3& p, const Vec3& normal) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] != 0) return std::abs(p[axis] - 0.5 * normal[axis]);
  }
  return 0;
}

}  // namespace trace
