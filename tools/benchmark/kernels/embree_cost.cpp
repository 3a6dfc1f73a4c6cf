#include "tools/benchmark/kernels/embree_cost.hpp"

#ifdef TRACE_EMBREE

#include <embree3/rtcore.h>

#include <stdexcept>
#include <vector>

namespace trace::bench {
namespace {

constexpr unsigned width = 8;

double surface(const RTCBounds& b) {
  const double x = double(b.upper_x) - b.lower_x, y = double(b.upper_y) - b.lower_y,
               z = double(b.upper_z) - b.lower_z;
  return x * y + y * z + z * x;
}

// What its parent has to know of a node or leaf is in the parent: the boxes of its children.
struct Node {
  std::size_t items = 0;  // of a leaf; 0 for a node
  unsigned children = 0;
  Node* child[width]{};
  double surfaces[width]{};
};

void* make_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node;
}

void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive*, std::size_t count, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node{.items = count};
}

void set_children(void* node, void** children, unsigned count, void*) {
  auto* to = static_cast<Node*>(node);
  to->children = count;
  for (unsigned i = 0; i < count; ++i) to->child[i] = static_cast<Node*>(children[i]);
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<Node*>(node)->surfaces[i] = surface(*bounds[i]);
}

double cost_below(const Node& root, unsigned block) {
  double sum = 0;
  std::vector<const Node*> waiting{&root};
  while (!waiting.empty()) {
    const Node& node = *waiting.back();
    waiting.pop_back();
    for (unsigned i = 0; i < node.children; ++i) {
      const Node& child = *node.child[i];
      const std::size_t blocks = (child.items + block - 1) / block;
      sum += node.surfaces[i] * (child.items == 0 ? 1.0 : static_cast<double>(blocks));
      waiting.push_back(&child);
    }
  }
  return sum;
}

}  // namespace

std::optional<double> embree_surface_area_cost(std::span<const Bounds> boxes, unsigned block) {
  std::vector<RTCBuildPrimitive> items;
  items.reserve(boxes.size());
  Bounds all;
  for (const Bounds& b : boxes) {
    all.add(b);
    items.push_back({float(b.min.x), float(b.min.y), float(b.min.z), 0, float(b.max.x), float(b.max.y),
                     float(b.max.z), unsigned(items.size())});
  }
  const RTCDevice device = rtcNewDevice(nullptr);
  const RTCBVH bvh = rtcNewBVH(device);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = width;
  arguments.sahBlockSize = block;
  arguments.maxLeafSize = block > 1 ? 8 : 4;
  arguments.bvh = bvh;
  arguments.primitives = items.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = items.size();
  arguments.createNode = make_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = make_leaf;
  const auto* root = static_cast<const Node*>(rtcBuildBVH(&arguments));
  const Vec3 size = all.max - all.min;
  const double whole = size.x * size.y + size.y * size.z + size.z * size.x;
  const std::optional<double> cost =
      root ? std::optional(1 + cost_below(*root, block) / whole) : std::nullopt;
  rtcReleaseBVH(bvh);
  rtcReleaseDevice(device);
  return cost;
}

}  // namespace trace::bench

#else

namespace trace::bench {

std::optional<double> embree_surface_area_cost(std::span<const Bounds>, unsigned) {
  return std::nullopt;
}

}  // namespace trace::bench

#endif
