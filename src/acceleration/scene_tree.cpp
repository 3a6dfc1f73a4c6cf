#include "acceleration/scene_tree.hpp"

#include <algorithm>
#include <optional>

#include "acceleration/bvh_build.hpp"

namespace trace {
namespace {

constexpr LeafSizes leaf_sizes{1, 2, 1};
constexpr std::size_t max_unsorted = 3;  // so few objects are sooner tested than sorted

// The world ray in the space of one object after another; objects of the same frame share the work.
class FrameRays {
 public:
  FrameRays(const Scene& scene, const Ray& ray) : scene_(scene), world_(ray) {}

  const ObjectRay& in(std::uint32_t frame) {
    if (!current_ || frame_ != frame) {
      current_.emplace(scene_.frames[frame], world_);
      frame_ = frame;
    }
    return *current_;
  }

 private:
  const Scene& scene_;
  const Ray& world_;
  std::optional<ObjectRay> current_;
  std::uint32_t frame_ = 0;
};

}  // namespace

SceneTree::SceneTree(const Scene& scene, int threads, InstructionSet set, bool always_sorted)
    : scene_(scene) {
  ThreadBudget budget(threads_or_all(threads));
  sort(always_sorted, budget);
  meshes_.reserve(scene.meshes.size());
  for (const SceneMesh& mesh : scene.meshes) meshes_.emplace_back(mesh.geometry, set, budget);
}

void SceneTree::sort(bool always, ThreadBudget& budget) {
  std::vector<std::uint32_t> bounded, unbounded;
  for (std::uint32_t id = 0; id < scene_.objects.size(); ++id) {
    (scene_.objects[id].bounds.unbounded() ? unbounded : bounded).push_back(id);
  }
  if (bounded.size() <= (always ? 0 : max_unsorted)) return;
  Bounds all;
  for (const std::uint32_t id : bounded) all.add(scene_.objects[id].bounds);
  BvhItems items(all, bounded.size());
  for (const std::uint32_t id : bounded) items.add(scene_.objects[id].bounds);
  bvh_ = build_bvh(std::move(items), leaf_sizes, budget);
  if (unbounded.empty()) return;
  for (std::uint32_t& item : bvh_.order) item = bounded[item];
  for (const std::uint32_t id : unbounded) bvh_.order.push_back(id);
  unbounded_ = static_cast<std::uint32_t>(unbounded.size());
}

std::size_t SceneTree::bytes() const {
  std::size_t sum = bytes_of(bvh_) + meshes_.size() * sizeof(MeshTree);
  for (const MeshTree& mesh : meshes_) sum += mesh.bytes();
  return sum;
}

template <class Leaf>
void SceneTree::visit_leaves(const Ray& ray, double limit, Leaf&& leaf) const {
  if (bvh_.nodes.empty()) {
    leaf(0, static_cast<std::uint32_t>(scene_.objects.size()), limit);
  } else {
    if (unbounded_ > 0) limit = leaf(first_unbounded(), unbounded_, limit);
    if (limit < 0) return;
    traverse(bvh_, BvhRay(bvh_, ray), limit, leaf);
  }
}

Hit SceneTree::closest(const Ray& ray, bool cull) const {
  Hit best;
  std::optional<Hit> gap;
  const Reciprocal inverse(ray);
  FrameRays rays(scene_, ray);
  visit_leaves(ray, best.t, [&](std::uint32_t first, std::uint32_t count, double) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const std::uint32_t id = object_at(i);
      const Object& object = scene_.objects[id];
      if (!hits_bounds(object.bounds, ray, inverse)) continue;
      const ObjectRay& local = rays.in(object.frame);
      LocalHit hit;
      const bool found = std::visit(
          [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, MeshId>) {
              return meshes_[shape.index].closest(local.ray, best.t * local.scale, cull, hit);
            } else {
              return shape.intersect(local.ray, hit);
            }
          },
          object.shape);
      if (!found) continue;
      const double t = hit.t / local.scale;
      if (hit.is_gap) {
        if (!gap || t < gap->t || (t == gap->t && id < gap->object)) gap = {t, id, hit};
      } else if (t < best.t || (t == best.t && id < best.object)) {
        best = {t, id, hit};
      }
    }
    return best.t;
  });
  // Where something else is hit at the place of a gap in a mesh, it is that.
  return gap && gap->t < best.t && !same_place(best.t, gap->t) ? *gap : best;
}

bool SceneTree::occluded(const Ray& ray, double limit) const {
  bool found = false;
  const Reciprocal inverse(ray);
  FrameRays rays(scene_, ray);
  visit_leaves(ray, limit, [&](std::uint32_t first, std::uint32_t count, double current) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Object& object = scene_.objects[object_at(i)];
      if (!hits_bounds(object.bounds, ray, inverse)) continue;
      const ObjectRay& local = rays.in(object.frame);
      found = std::visit(
          [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, MeshId>) {
              return meshes_[shape.index].occludes(local.ray, local.scale, limit);
            } else {
              LocalHit hit;
              return shape.intersect(local.ray, hit) && hit.t / local.scale < limit;
            }
          },
          object.shape);
      if (found) return -1.0;
    }
    return current;
  });
  return found;
}

}  // namespace trace
