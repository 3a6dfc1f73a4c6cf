// The shapes for packets: the formulas of their intersect() and distance(), lane by lane the same bits.
//
// intersect() takes rays in the space of the object and returns those of the `active` lanes that hit, for
// which it fills `hits`. Lanes for which the scalar code would go ways that have no vector form are added to
// `unusual`; what is returned and filled for them does not count. distance() is how far a point is from the
// surface that was hit, with the rounding of its formula.
#if defined(TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP
#undef TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP
#endif

#include "geometry/packet/bounds-inl.hpp"
#include "geometry/packet/box-inl.hpp"
#include "geometry/packet/cone-inl.hpp"
#include "geometry/packet/cylinder-inl.hpp"
#include "geometry/packet/sphere-inl.hpp"
#include "geometry/packet/square-inl.hpp"

#endif
