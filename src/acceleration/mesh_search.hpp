// What a search through a mesh has found so far: one face after another is tested by the exact formulas.
#pragma once

#include "acceleration/mesh_gaps.hpp"
#include "acceleration/mesh_tree.hpp"

namespace trace {

// The nearest face, as MeshTree::closest() promises.
class NearestFace {
 public:
  NearestFace(const MeshTree& tree, const Ray& ray, bool cull)
      : tree_(tree), ray_(ray), reach_(tree.reach_to(ray.origin)), cull_(cull) {}

  double reach() const { return reach_; }

  // The face at `place`; returns the limit from then on.
  double test(std::uint32_t place, double limit) {
    TriangleHit candidate;
    const Meeting meeting = tree_.meet(place, ray_, reach_, best_.t, candidate);
    if (meeting == Meeting::none || candidate.t > best_.t) return limit;
    const std::uint32_t face = tree_.faces()[place].face;
    if (meeting == Meeting::hit && candidate.t == best_.t && face > face_) return limit;
    if (cull_ && tree_.is_from_behind(place, ray_)) return limit;
    if (meeting != Meeting::hit) {
      gaps_.add({candidate, face, meeting == Meeting::edge_gap, tree_.is_from_behind(place, ray_)});
      return limit;
    }
    best_ = candidate;
    face_ = face;
    return best_.t < limit ? best_.t : limit;
  }

  bool result(LocalHit& hit) const {
    TriangleHit best = best_;
    std::uint32_t face = face_;
    // Where the course hits another face at the place of a gap, it is that face.
    const MeshGap* gap = gaps_.nearest();
    hit.is_gap = gap && gap->hit.t < best.t && !same_place(best.t, gap->hit.t);
    if (hit.is_gap) {
      best = gap->hit;
      face = gap->face;
    }
    hit.t = best.t;
    hit.uv = Vec2(best.u, best.v);
    hit.part = face;
    return best.t < std::numeric_limits<double>::infinity();
  }

 private:
  const MeshTree& tree_;
  const Ray& ray_;
  double reach_;
  bool cull_;
  TriangleHit best_{std::numeric_limits<double>::infinity(), 0, 0};
  std::uint32_t face_ = 0;
  MeshGaps gaps_;
};

// Any face, as MeshTree::occludes() promises.
class AnyFace {
 public:
  AnyFace(const MeshTree& tree, const Ray& ray, double scale, double limit)
      : tree_(tree),
        ray_(ray),
        reach_(tree.reach_to(ray.origin)),
        scale_(scale),
        limit_(limit),
        furthest_(limit * scale * (1 + gamma(2))),
        gaps_up_to_(limit * scale * gaps_before_light) {}

  double reach() const { return reach_; }

  // Negative, to end the search, where the face at `place` is hit.
  double test(std::uint32_t place, double limit) {
    TriangleHit candidate;
    const Meeting meeting = tree_.meet(place, ray_, reach_, furthest_, candidate);
    if (meeting == Meeting::none || !(candidate.t / scale_ < limit_)) return limit;
    if (meeting == Meeting::hit) {
      found_ = true;
      return -1;
    }
    if (candidate.t < gaps_up_to_) {
      gaps_.add({candidate, tree_.faces()[place].face, meeting == Meeting::edge_gap,
                 tree_.is_from_behind(place, ray_)});
    }
    return limit;
  }

  bool result() const { return found_ || gaps_.nearest() != nullptr; }

 private:
  const MeshTree& tree_;
  const Ray& ray_;
  double reach_, scale_, limit_, furthest_, gaps_up_to_;
  bool found_ = false;
  MeshGaps gaps_;
};

}  // namespace trace
