// Rays into the space of an object, and normals out of it: geometry/frame.hpp for packets.
#if defined(TRACE_GEOMETRY_PACKET_FRAME_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_FRAME_INL_HPP
#undef TRACE_GEOMETRY_PACKET_FRAME_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_FRAME_INL_HPP
#endif

#include "geometry/frame.hpp"
#include "geometry/packet/rays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

HWY_INLINE Vectors point_times(const Mat4& m, const Vectors& p) {
  return {(m[0].x * p.x + m[1].x * p.y) + (m[2].x * p.z + Numbers(m[3].x)),
          (m[0].y * p.x + m[1].y * p.y) + (m[2].y * p.z + Numbers(m[3].y)),
          (m[0].z * p.x + m[1].z * p.y) + (m[2].z * p.z + Numbers(m[3].z))};
}
HWY_INLINE Vectors direction_times(const Mat4& m, const Vectors& d) {
  return {(m[0].x * d.x + m[1].x * d.y) + (m[2].x * d.z + Numbers(m[3].x * 0)),
          (m[0].y * d.x + m[1].y * d.y) + (m[2].y * d.z + Numbers(m[3].y * 0)),
          (m[0].z * d.x + m[1].z * d.y) + (m[2].z * d.z + Numbers(m[3].z * 0))};
}
HWY_INLINE Vectors times(const Mat3& m, const Vectors& v) {
  return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
          m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}
HWY_INLINE Numbers bound_at(const LinearBound& bound, const Numbers& largest_coordinate) {
  return bound.slope * largest_coordinate + Numbers(bound.constant);
}

// geometry/unit_vector.hpp; `unusual` gets the lanes whose squares leave the range of doubles, the result of
// which does not count.
struct UnitVectors {
  Vectors direction;
  Numbers length;
};
HWY_INLINE UnitVectors unit_vectors(const Vectors& v, Mask& unusual) {
  const Numbers square = dot(v, v);
  unusual |= !((square > 0x1p-900) & (square < 0x1p+900));
  const Numbers length = sqrt(square);
  return {(1.0 / length) * v, length};
}

HWY_INLINE Vectors world_normals(const Frame& frame, const Vectors& n, Mask& unusual) {
  return unit_vectors(times(frame.normal_to_world, n), unusual).direction;
}

// ObjectRay for packets.
struct ObjectRays {
  Rays rays;
  Numbers scale;
  Mask unusual;  // lanes that only the scalar code can carry

  // Written in place: the whole is too large to be copied.
  HWY_INLINE void carry(const Frame& frame, const Rays& world) {
    unusual = no_lanes();
    rays.origin = point_times(frame.to_object, world.origin);
    const Vectors end = point_times(frame.to_object, world.origin + world.direction);
    const UnitVectors along = unit_vectors(end - rays.origin, unusual);
    const Numbers furthest = largest(world.origin);
    unusual |= !(bound_at(frame.difference_bound(), furthest) <= 0x1p-40 * along.length);
    scale = along.length;
    rays.direction = along.direction;
    rays.origin_error =
        frame.to_object_stretch * world.origin_error + bound_at(frame.error_bound(), furthest);
    rays.least_t = world.least_t * scale;
  }
};

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
