// Which object a ray hits, in any kind of number.
#pragma once

#include "acceleration/scene_tree.hpp"
#include "precision/box.hpp"
#include "precision/box_walk.hpp"
#include "precision/cylinder.hpp"
#include "precision/scene_in.hpp"
#include "precision/sphere.hpp"
#include "precision/square.hpp"

namespace trace::precision {

// The language's test before an object is asked: slabs without tolerance, an axis along which the ray does
// not move is passed over.
template <class T>
bool hits_bounds(const Vec3<T>& low, const Vec3<T>& high, const Ray<T>& ray) {
  T enter = -std::numeric_limits<T>::infinity(), leave = std::numeric_limits<T>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const T d = ray.direction[axis];
    if (d == 0) continue;
    const T at_low = (low[axis] - ray.origin[axis]) / d, at_high = (high[axis] - ray.origin[axis]) / d;
    enter = std::max(enter, std::min(at_low, at_high));
    leave = std::min(leave, std::max(at_low, at_high));
  }
  return enter <= leave && leave >= 0;
}

template <class T>
class Search {
 public:
  // Refers to its arguments, which must outlive it and be of one scene.
  Search(const SceneIn<T>& scene, const SceneTree& tree) : scene_(scene), tree_(tree), walked_(tree.bvh()) {
    for (std::uint32_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
      walked_meshes_.emplace_back(tree.mesh(MeshId{mesh}).bvh());
    }
  }

  // As SceneTree's: the nearest hit, of equal ones the first in the file; with `cull` mesh faces seen from
  // behind are passed over.
  Hit<T> closest(const Ray<T>& ray, bool cull) const {
    return find(ray, cull, -std::numeric_limits<T>::infinity());
  }
  // Whether anything is hit nearer than `limit`; no culling.
  bool occluded(const Ray<T>& ray, T limit) const { return find(ray, false, limit).t < limit; }

 private:
  // Any hit nearer than `enough` ends the search.
  Hit<T> find(const Ray<T>& ray, bool cull, T enough) const;
  bool hits_mesh(MeshId id, const Ray<T>& ray, T limit, bool cull, T enough, LocalHit<T>& hit) const;

  // The world ray in the space of an object, direction times matrix; `scale` times a t of the world is one
  // there.
  struct ObjectRay {
    Ray<T> ray;
    T scale;

    ObjectRay(const FrameIn<T>& frame, const Ray<T>& world) {
      const Vec3<T> along(frame.to_object * Vec4<T>(world.direction, 0));
      scale = glm::length(along);
      ray = {frame.point_to_object(world.origin), along / scale, world.least_t * scale};
    }
  };

  const SceneIn<T>& scene_;
  const SceneTree& tree_;
  WalkedTree<T> walked_;
  std::vector<WalkedTree<T>> walked_meshes_;
};

template <class T>
Hit<T> Search<T>::find(const Ray<T>& ray, bool cull, T enough) const {
  Hit<T> best;
  const auto test = [&](std::uint32_t first, std::uint32_t count, T) -> T {
    for (std::uint32_t place = first; place < first + count; ++place) {
      const std::uint32_t id = tree_.object_at(place);
      const ObjectIn<T>& object = scene_.objects[id];
      if (!hits_bounds(object.low, object.high, ray)) continue;
      const ObjectRay local(scene_.frames[object.frame], ray);
      LocalHit<T> hit;
      const bool found = std::visit(
          [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, MeshId>) {
              return hits_mesh(shape, local.ray, best.t * local.scale, cull, enough * local.scale, hit);
            } else {
              return intersect(shape, local.ray, hit);
            }
          },
          object.shape);
      const T t = hit.t / local.scale;
      if (!found || !(t < best.t || (t == best.t && id < best.object))) continue;
      best = {t, id, hit};
      if (best.t < enough) return -1;
    }
    return best.t;
  };
  if (tree_.is_list()) {
    test(0, static_cast<std::uint32_t>(scene_.objects.size()), best.t);
  } else {
    walked_.walk(ray, best.t, test);
  }
  return best;
}

template <class T>
bool Search<T>::hits_mesh(MeshId id, const Ray<T>& ray, T limit, bool cull, T enough,
                          LocalHit<T>& hit) const {
  const MeshIn<T>& mesh = scene_.meshes[id.index];
  const std::span<const LeafFace> faces = tree_.mesh(id).faces();
  hit.t = std::numeric_limits<T>::infinity();
  walked_meshes_[id.index].walk(ray, limit, [&](std::uint32_t first, std::uint32_t count, T current) -> T {
    for (std::uint32_t place = first; place < first + count; ++place) {
      const LeafFace& face = faces[place];
      const Triangle<T> triangle = mesh.triangle(face.corners);
      LocalHit<T> candidate;
      if (!intersect(triangle, ray, candidate)) continue;
      if (!(candidate.t < hit.t || (candidate.t == hit.t && face.face < hit.part))) continue;
      if (cull && glm::dot(glm::cross(triangle.ab, triangle.ac), ray.direction) > 0) continue;
      hit.t = candidate.t;
      hit.uv = candidate.uv;
      hit.part = face.face;
      if (hit.t < enough) return -1;
    }
    return std::min(current, hit.t);
  });
  return hit.t < std::numeric_limits<T>::infinity();
}

}  // namespace trace::precision
