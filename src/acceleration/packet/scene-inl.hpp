// A packet of rays through the scene: SceneTree::closest and occluded for packets, with the same results.
//
// Lanes for which something is unusual (a triangle that only exact arithmetic decides, a gap, coordinates at
// the end of the range of numbers) are asked of SceneTree one by one.
#if defined(TRACE_ACCELERATION_PACKET_SCENE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_ACCELERATION_PACKET_SCENE_INL_HPP
#undef TRACE_ACCELERATION_PACKET_SCENE_INL_HPP
#else
#define TRACE_ACCELERATION_PACKET_SCENE_INL_HPP
#endif

#include "acceleration/packet/mesh-inl.hpp"
#include "acceleration/scene_tree.hpp"
#include "geometry/packet/frame-inl.hpp"
#include "geometry/packet/shapes-inl.hpp"
#include "scene/shape.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// t is infinite where there is no hit.
struct Hits {
  Numbers t;
  Numbers object;  // index into Scene::objects
  LocalHits local;
};

// Shapes without a kernel of their own: ray by ray, with the scalar code.
struct OtherShape {
  const Shape& shape;
};

HWY_MAYBE_UNUSED static HWY_NOINLINE Mask intersect(const OtherShape& other, const Rays& rays,
                                                    const Mask& active, LocalHits& hits, Mask&) {
  const RayLanes one(rays);
  Lanes t(Numbers(0.0));
  VectorLanes normal(Vectors(0.0, 0.0, 1.0));
  unsigned found = 0;
  for (const std::size_t i : each_lane(active)) {
    LocalHit hit;
    if (!trace::intersect(other.shape, one[i], hit)) continue;
    found |= 1u << i;
    t.at[i] = hit.t;
    normal.set(i, hit.normal);
  }
  hits.t = t.numbers();
  hits.normal = normal.vectors();
  hits.u = hits.v = hits.part = 0.0;
  return mask_of(found);
}

HWY_MAYBE_UNUSED static HWY_NOINLINE Numbers distance(const OtherShape& other, const Vectors& p,
                                                      const Vectors& normal) {
  const VectorLanes points(p), normals(normal);
  Lanes result;
  for (std::size_t i = 0; i < lanes; ++i) {
    result.at[i] = distance_with_rounding(other.shape, points[i], normals[i]);
  }
  return result.numbers();
}

// Calls with the shape's own type, or OtherShape; not for meshes.
template <class Call>
HWY_INLINE auto with_primitive(const Shape& shape, const Call& call) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return call(*sphere);
  if (const auto* box = std::get_if<Box>(&shape)) return call(*box);
  if (const auto* square = std::get_if<Square>(&shape)) return call(*square);
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return call(*cylinder);
  if (const auto* cone = std::get_if<Cone>(&shape)) return call(*cone);
  return call(OtherShape{shape});
}

HWY_INLINE Mask intersect_primitive(const Shape& shape, const Rays& rays, const Mask& asked, LocalHits& hits,
                                    Mask& odd) {
  // Inlined, so that what the caller does not use of the hits is not computed.
  return with_primitive(
      shape, [&](const auto& s) HWY_ATTR
      __attribute__((always_inline)) { return intersect(s, rays, asked, hits, odd); });
}

// The rays of a packet in the space of one object after another.
class FramePackets {
 public:
  HWY_INLINE FramePackets(const Scene& scene, const Rays& rays) : scene_(scene), world_(rays) {}

  HWY_INLINE const ObjectRays& in(std::uint32_t frame) {
    if (!known_ || frame_ != frame) {
      rays_.carry(scene_.frames[frame], world_);
      frame_ = frame;
      known_ = true;
    }
    return rays_;
  }

 private:
  const Scene& scene_;
  const Rays& world_;
  ObjectRays rays_;
  std::uint32_t frame_ = 0;
  bool known_ = false;
};

class ClosestObjects {
 public:
  Hits& best;
  Mask unusual;

  // `nearest` gets the hits: too large to be copied.
  HWY_INLINE ClosestObjects(const Scene& scene, const SceneTree& tree, const Rays& rays, const Mask& active,
                            bool cull, Hits& nearest)
      : best(nearest),
        scene_(scene),
        tree_(tree),
        rays_(rays),
        inverse_(rays),
        frames_(scene, rays),
        cull_(cull),
        going_(active) {
    best.t = std::numeric_limits<double>::infinity();
    best.object = 0.0;
    best.local = {0.0, Vectors(0.0, 0.0, 1.0), 0.0, 0.0, 0.0};
    unusual = no_lanes();
  }

  HWY_INLINE void foresee(std::uint32_t, std::uint32_t) const {}  // what an object needs lies in many places
  HWY_INLINE bool visit(std::uint32_t first, std::uint32_t count, unsigned touching) {
    Mask changed = no_lanes();
    for (std::uint32_t i = first; i < first + count; ++i) {
      const std::uint32_t id = tree_.object_at(i);
      const Object& object = scene_.objects[id];
      const Mask asked = hit_bounds(object.bounds, rays_, inverse_, mask_of(touching) & going_);
      if (none(asked)) continue;
      const ObjectRays& local = frames_.in(object.frame);
      LocalHits hits;
      Mask odd = asked & local.unusual;
      const Mask found = intersect_shape(object.shape, local, without(asked, odd), hits, odd);
      const Numbers t = hits.t / local.scale;
      const Numbers number = id;
      const Mask nearer = without(found, odd) & ((t < best.t) | ((t == best.t) & (number < best.object)));
      if (any(odd)) {
        unusual |= odd;
        going_ = without(going_, odd);
        changed |= odd;
      }
      if (none(nearer)) continue;
      best.t = select(nearer, t, best.t);
      best.object = select(nearer, number, best.object);
      best.local = select(nearer, hits, best.local);
      changed |= nearer;
    }
    return any(changed);
  }
  HWY_INLINE Numbers limits() const { return best.t; }
  HWY_INLINE unsigned going() const { return bits_of(going_); }

 private:
  HWY_INLINE Mask intersect_shape(const Shape& shape, const ObjectRays& local, const Mask& asked,
                                  LocalHits& hits, Mask& odd) {
    if (const auto* mesh = std::get_if<MeshId>(&shape)) {
      return intersect_mesh(tree_.mesh(*mesh), local.rays, asked, best.t * local.scale, cull_, hits, odd);
    }
    return intersect_primitive(shape, local.rays, asked, hits, odd);
  }

  const Scene& scene_;
  const SceneTree& tree_;
  const Rays& rays_;
  Reciprocals inverse_;
  FramePackets frames_;
  bool cull_;
  Mask going_;
};

class AnyObjects {
 public:
  HWY_INLINE AnyObjects(const Scene& scene, const SceneTree& tree, const Rays& rays, const Mask& active,
                        const Numbers& limit)
      : scene_(scene),
        tree_(tree),
        rays_(rays),
        inverse_(rays),
        frames_(scene, rays),
        limit_(limit),
        going_(active),
        found(no_lanes()),
        unusual(no_lanes()) {}

  HWY_INLINE void foresee(std::uint32_t, std::uint32_t) const {}  // what an object needs lies in many places
  HWY_INLINE bool visit(std::uint32_t first, std::uint32_t count, unsigned touching) {
    const Mask before = going_;
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Object& object = scene_.objects[tree_.object_at(i)];
      const Mask asked = hit_bounds(object.bounds, rays_, inverse_, mask_of(touching) & going_);
      if (none(asked)) continue;
      const ObjectRays& local = frames_.in(object.frame);
      Mask odd = asked & local.unusual;
      const Mask hit = without(occluded_by(object.shape, local, without(asked, odd), odd), odd);
      found |= hit;
      unusual |= odd;
      going_ = without(going_, hit | odd);
    }
    return any(without(before, going_));
  }
  HWY_INLINE Numbers limits() const { return limit_; }
  HWY_INLINE unsigned going() const { return bits_of(going_); }

 private:
  HWY_INLINE Mask occluded_by(const Shape& shape, const ObjectRays& local, const Mask& asked, Mask& odd) {
    if (const auto* mesh = std::get_if<MeshId>(&shape)) {
      return occluded_by_mesh(tree_.mesh(*mesh), local.rays, asked, local.scale, limit_, odd);
    }
    LocalHits hits;
    const Mask hit = intersect_primitive(shape, local.rays, asked, hits, odd);
    return hit & (hits.t / local.scale < limit_);
  }

  const Scene& scene_;
  const SceneTree& tree_;
  const Rays& rays_;
  Reciprocals inverse_;
  FramePackets frames_;
  Numbers limit_;
  Mask going_;

 public:
  Mask found;
  Mask unusual;
};

template <class Leaf>
HWY_INLINE void visit_leaves(const Scene& scene, const SceneTree& tree, const Rays& rays, const Mask& active,
                             Leaf& leaf) {
  if (tree.is_list()) {
    leaf.visit(0, static_cast<std::uint32_t>(scene.objects.size()), bits_of(active));
    return;
  }
  Mask going = active;
  if (tree.unbounded() > 0) {
    leaf.visit(tree.first_unbounded(), tree.unbounded(), bits_of(active));
    going &= mask_of(leaf.going());
    if (none(going)) return;
  }
  traverse(tree.bvh(), rays, going, leaf);
}

HWY_MAYBE_UNUSED static HWY_NOINLINE void closest(const Scene& scene, const SceneTree& tree, const Rays& rays,
                                                  const Mask& active, bool cull, Hits& result) {
  ClosestObjects leaf(scene, tree, rays, active, cull, result);
  visit_leaves(scene, tree, rays, active, leaf);
  if (none(leaf.unusual)) return;
  const RayLanes one(rays);
  Lanes t(result.t), object(result.object), local_t(result.local.t), u(result.local.u), v(result.local.v),
      part(result.local.part);
  VectorLanes normal(result.local.normal);
  for (const std::size_t i : each_lane(leaf.unusual)) {
    const Hit hit = tree.closest(one[i], cull);
    t.at[i] = hit.t;
    object.at[i] = hit.object;
    local_t.at[i] = hit.local.t;
    u.at[i] = hit.local.uv.x;
    v.at[i] = hit.local.uv.y;
    part.at[i] = hit.local.part;
    normal.set(i, hit.local.normal);
  }
  result = {t.numbers(),
            object.numbers(),
            {local_t.numbers(), normal.vectors(), u.numbers(), v.numbers(), part.numbers()}};
}

// Which rays hit anything nearer than `limit`.
HWY_MAYBE_UNUSED static HWY_NOINLINE Mask occluded(const Scene& scene, const SceneTree& tree,
                                                   const Rays& rays, const Mask& active,
                                                   const Numbers& limit) {
  AnyObjects leaf(scene, tree, rays, active, limit);
  visit_leaves(scene, tree, rays, active, leaf);
  if (none(leaf.unusual)) return leaf.found;
  const RayLanes one(rays);
  const Lanes limits(limit);
  unsigned found = bits_of(leaf.found);
  for (const std::size_t i : each_lane(leaf.unusual)) {
    if (tree.occluded(one[i], limits.at[i])) found |= 1u << i;
  }
  return mask_of(found);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
