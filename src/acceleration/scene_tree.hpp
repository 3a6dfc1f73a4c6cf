// Which object a ray hits: a hierarchy over the objects, and one in each mesh. Objects without an end have no
// box that a hierarchy could use: every ray asks them, before all others.
#pragma once

#include <vector>

#include "acceleration/bvh.hpp"
#include "acceleration/mesh_tree.hpp"
#include "scene/scene.hpp"

namespace trace {

struct Hit {
  double t = std::numeric_limits<double>::infinity();  // in the world
  std::uint32_t object = 0;                            // index into Scene::objects
  LocalHit local;

  explicit operator bool() const { return t < std::numeric_limits<double>::infinity(); }
};

class SceneTree {
 public:
  // Refers to `scene`, which must outlive it. Built by so many threads; 0: as many as the machine has. What
  // is built does not depend on it. `always_sorted`: a hierarchy over a handful of objects too, which finds
  // the same.
  explicit SceneTree(const Scene& scene, int threads = 0, InstructionSet set = best_instruction_set(),
                     bool always_sorted = false);

  // The nearest hit; of hits at the same t that of the object first in the file. With `cull`, mesh faces seen
  // from behind are passed over.
  Hit closest(const Ray& ray, bool cull) const;

  // Whether anything is hit nearer than `limit`; no culling.
  bool occluded(const Ray& ray, double limit) const;

  // What searching it in other ways takes. A handful of objects is a list, which is tested as a whole.
  bool is_list() const { return bvh_.nodes.empty(); }
  const Bvh& bvh() const { return bvh_; }
  // The objects without an end beside a hierarchy: so many places from the first one on.
  std::uint32_t first_unbounded() const { return static_cast<std::uint32_t>(bvh_.order.size()) - unbounded_; }
  std::uint32_t unbounded() const { return unbounded_; }
  // The object at a place in the order of the leaves, with the unbounded objects behind them, or of the list.
  std::uint32_t object_at(std::uint32_t place) const { return is_list() ? place : bvh_.order[place]; }
  const MeshTree& mesh(MeshId id) const { return meshes_[id.index]; }

  // Of memory, that of the meshes themselves not counted.
  std::size_t bytes() const;

 private:
  void sort(bool always, ThreadBudget& budget);
  // Calls leaf(first, count, limit) as traverse() does; `first` counts places of object_at().
  template <class Leaf>
  void visit_leaves(const Ray& ray, double limit, Leaf&& leaf) const;

  const Scene& scene_;
  Bvh bvh_;
  std::uint32_t unbounded_ = 0;
  std::vector<MeshTree> meshes_;  // as Scene::meshes
};

}  // namespace trace
