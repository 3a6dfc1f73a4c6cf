// Vectors, rays and hits side by side; see numbers-inl.hpp. The order of operations is that of GLM, which is
// part of the picture (geometry/vector.hpp).
#if defined(TRACE_GEOMETRY_PACKET_RAYS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_RAYS_INL_HPP
#undef TRACE_GEOMETRY_PACKET_RAYS_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_RAYS_INL_HPP
#endif

#include "geometry/packet/numbers-inl.hpp"
#include "geometry/ray.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

struct Vectors {
  Numbers x, y, z;

  Vectors() = default;
  HWY_INLINE Vectors(const Numbers& all_x, const Numbers& all_y, const Numbers& all_z)
      : x(all_x), y(all_y), z(all_z) {}
  HWY_INLINE Vectors(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: the same in all lanes
};

HWY_INLINE Vectors operator+(const Vectors& a, const Vectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vectors operator-(const Vectors& a, const Vectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vectors operator-(const Vectors& a) {
  return {-a.x, -a.y, -a.z};
}
HWY_INLINE Vectors operator*(const Vectors& a, const Vectors& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE Vectors operator*(const Numbers& s, const Vectors& v) {
  return {s * v.x, s * v.y, s * v.z};
}

HWY_INLINE Numbers dot(const Vectors& a, const Vectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
HWY_INLINE Vectors select(const Mask& m, const Vectors& yes, const Vectors& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
HWY_INLINE Vectors normalized(const Vectors& v) {
  return (1.0 / sqrt(dot(v, v))) * v;
}

// geometry/rounding.hpp
HWY_INLINE Numbers largest(const Vectors& v) {
  const Numbers x = abs(v.x), y = abs(v.y), z = abs(v.z);
  const Numbers xy = select(x > y, x, y);
  return select(xy > z, xy, z);
}
HWY_INLINE Numbers sum_of_sizes(const Vectors& v) {
  return abs(v.x) + abs(v.y) + abs(v.z);
}
HWY_INLINE Numbers difference_of_products(const Numbers& a, const Numbers& b, const Numbers& c,
                                          const Numbers& d) {
  const Numbers cd = c * d;
  return fused(a, b, -cd) + fused(-c, d, cd);
}
HWY_INLINE Vectors accurate_cross(const Vectors& a, const Vectors& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

HWY_INLINE Mask is_zero(const Vectors& v) {
  return (v.x == 0.0) & (v.y == 0.0) & (v.z == 0.0);
}
// shading/partial_rgb.hpp: 0 times a number is 0, and times infinity or NaN is NaN.
HWY_INLINE Mask all_finite(const Vectors& v) {
  return (v.x * 0.0 + v.y * 0.0 + v.z * 0.0) == 0.0;
}

// geometry/ray.hpp
struct Rays {
  Vectors origin, direction;
  Numbers origin_error, least_t;

  HWY_INLINE Vectors at(const Numbers& t) const { return origin + t * direction; }
};

// The local hits of one object or of one mesh; `part` of a mesh is the face. Only the lanes that hit count.
struct LocalHits {
  Numbers t;
  Vectors normal;
  Numbers u, v;
  Numbers part;
};

HWY_INLINE LocalHits select(const Mask& m, const LocalHits& yes, const LocalHits& no) {
  return {select(m, yes.t, no.t), select(m, yes.normal, no.normal), select(m, yes.u, no.u),
          select(m, yes.v, no.v), select(m, yes.part, no.part)};
}

// Vectors one by one.
struct VectorLanes {
  Lanes x, y, z;

  VectorLanes() = default;
  HWY_INLINE explicit VectorLanes(const Vectors& v) : x(v.x), y(v.y), z(v.z) {}
  HWY_INLINE void set(std::size_t i, const Vec3& v) {
    x.at[i] = v.x;
    y.at[i] = v.y;
    z.at[i] = v.z;
  }
  HWY_INLINE Vec3 operator[](std::size_t i) const { return {x.at[i], y.at[i], z.at[i]}; }
  HWY_INLINE Vectors vectors() const { return {x.numbers(), y.numbers(), z.numbers()}; }
};

// Rays one by one.
struct RayLanes {
  VectorLanes origin, direction;
  Lanes origin_error, least_t;

  HWY_INLINE explicit RayLanes(const Rays& r)
      : origin(r.origin), direction(r.direction), origin_error(r.origin_error), least_t(r.least_t) {}
  HWY_INLINE Ray operator[](std::size_t i) const {
    return {origin[i], direction[i], origin_error.at[i], least_t.at[i]};
  }
};

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
