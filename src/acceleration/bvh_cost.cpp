#include "acceleration/bvh.hpp"

namespace trace {
namespace {

// Half of it.
double surface(const BvhNode& node, int child) {
  double size[3];
  for (int axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<double>(node.high[axis][child]) - node.low[axis][child];
  }
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

double root_surface(const BvhNode& root) {
  BvhNode all = root;
  for (int axis = 0; axis < 3; ++axis) {
    for (int child = 1; child < bvh_width; ++child) {
      if (all.low[axis][child] < all.low[axis][0]) all.low[axis][0] = all.low[axis][child];
      if (all.high[axis][child] > all.high[axis][0]) all.high[axis][0] = all.high[axis][child];
    }
  }
  return surface(all, 0);
}

}  // namespace

double surface_area_cost(const Bvh& bvh, unsigned block) {
  if (bvh.nodes.empty()) return 0;
  const double whole = root_surface(bvh.nodes.front());
  if (!(whole > 0)) return 0;
  double sum = whole;
  for (const BvhNode& node : bvh.nodes) {
    for (int child = 0; child < bvh_width; ++child) {
      if (node.child[child] == 0 && node.count[child] == 0) continue;
      const unsigned blocks = (node.count[child] + block - 1) / block;
      sum += surface(node, child) * (node.count[child] == 0 ? 1 : blocks);
    }
  }
  return sum / whole;
}

}  // namespace trace
