#include "acceleration/bvh_build.hpp"

#include <algorithm>
#include <cstring>
#include <set>

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Items that traversal hands out for a ray.
std::multiset<std::uint32_t> touched(const Bvh& bvh, const Ray& ray) {
  std::multiset<std::uint32_t> result;
  traverse(bvh, BvhRay(bvh, ray), std::numeric_limits<double>::infinity(),
           [&](std::uint32_t first, std::uint32_t count, double limit) {
             for (std::uint32_t i = first; i < first + count; ++i) result.insert(bvh.order[i]);
             return limit;
           });
  return result;
}

std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> items) {
  std::vector<std::uint32_t> v(items.begin(), items.end());
  std::sort(v.begin(), v.end());
  return v;
}

std::vector<std::uint32_t> up_to(std::uint32_t n) {
  std::vector<std::uint32_t> v(n);
  for (std::uint32_t i = 0; i < n; ++i) v[i] = i;
  return v;
}

}  // namespace

TEST_CASE("a hierarchy of no items has no nodes and is never entered") {
  const Bvh bvh = build_bvh({}, 4);
  CHECK(bvh.nodes.empty());
  CHECK(touched(bvh, {Vec3(0), Vec3(0, 0, 1)}).empty());
}

TEST_CASE("every item stands once in the order of the leaves") {
  const std::uint32_t size = GENERATE(1u, 2u, 5u, 300u, 20'000u);
  const std::uint32_t max_leaf = GENERATE(1u, 4u, 255u);
  Random random(size);
  std::vector<Bounds> items(size);
  for (Bounds& b : items) {
    b.add(random.in_cube(10));
    b.add(random.in_cube(10));
  }
  const Bvh bvh = build_bvh(items, max_leaf);
  CHECK(sorted(bvh.order) == up_to(size));
  for (const BvhNode& node : bvh.nodes) {
    for (const std::uint8_t count : node.count) REQUIRE(count <= max_leaf);
  }
}

TEST_CASE("a ray is handed every item whose box it meets, and none twice") {
  Random random(GENERATE(range(1u, 6u)));
  std::vector<Bounds> items(200);
  for (Bounds& b : items) {
    const Vec3 corner = random.on_grid(8, 0.5);
    b.add(corner);
    if (random.below(4) != 0) b.add(corner + glm::abs(random.on_grid(8, 0.5)));  // some flat, some points
  }
  const Bvh bvh = build_bvh(items, 2);
  int missing = 0, met = 0;
  for (int i = 0; i < 300; ++i) {
    const Ray ray = random_ray(random);
    const std::multiset<std::uint32_t> found = touched(bvh, ray);
    for (std::uint32_t item = 0; item < items.size(); ++item) {
      REQUIRE(found.count(item) <= 1);
      bool inside_where_still = true;  // hits_bounds passes over axes along which the ray stands still
      for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0 &&
            (ray.origin[axis] < items[item].min[axis] || ray.origin[axis] > items[item].max[axis])) {
          inside_where_still = false;
        }
      }
      if (!inside_where_still || !hits_bounds(items[item], ray)) continue;
      ++met;
      if (found.count(item) == 0) ++missing;
    }
  }
  CHECK(met > 300);
  CHECK(missing == 0);
}

TEST_CASE("a ray beside everything enters no leaf") {
  std::vector<Bounds> items(50, Bounds{Vec3(-1), Vec3(1)});
  const Bvh bvh = build_bvh(items, 2);
  CHECK(touched(bvh, ray({5, 0, 0}, {0, 0, 1})).empty());
  CHECK(touched(bvh, ray({0, 0, 5}, {0, 0, 1})).empty());
  CHECK(touched(bvh, ray({0, 0, 5}, {0, 0, -1})).size() == 50);
}

TEST_CASE("items that are all at one place are split all the same") {
  const std::uint32_t size = GENERATE(2u, 1000u);
  const Bounds place = GENERATE(Bounds{Vec3(1), Vec3(1)}, Bounds{Vec3(0), Vec3(2)});
  const Bvh bvh = build_bvh(std::vector<Bounds>(size, place), 4);
  CHECK(touched(bvh, ray({1, 1, 5}, {0, 0, -1})).size() == size);
}

TEST_CASE("boxes without end are kept among finite ones") {
  const double infinity = std::numeric_limits<double>::infinity();
  Random random(3);
  std::vector<Bounds> items(64);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Vec3 corner = random.in_cube(5);
    items[i] = {corner, corner + Vec3(1)};
    if (i % 8 == 0) items[i] = {Vec3(-infinity), Vec3(infinity)};
    if (i % 8 == 1) items[i] = {Vec3(-infinity, corner.y, corner.z), Vec3(corner.x, infinity, infinity)};
    if (i % 8 == 2) items[i] = {Vec3(-1e300), Vec3(1e300)};
  }
  const Bvh bvh = build_bvh(items, 2);
  CHECK(sorted(bvh.order) == up_to(64));
  for (int i = 0; i < 50; ++i) {
    const auto found = touched(bvh, random_ray(random));
    for (std::uint32_t item = 0; item < 64; item += 8) {
      REQUIRE(found.count(item) == 1);
      REQUIRE(found.count(item + 2) == 1);
    }
  }
}

TEST_CASE("a traversal ends at once where the leaf says so, and passes over what is beyond its limit") {
  std::vector<Bounds> items;
  for (int i = 0; i < 64; ++i) items.push_back({Vec3(-1, -1, 3.0 * i), Vec3(1, 1, 3.0 * i + 1)});
  const Bvh bvh = build_bvh(items, 1);
  const Ray along = ray({0, 0, -1}, {0, 0, 1});
  int leaves = 0;
  traverse(bvh, BvhRay(bvh, along), 1e9, [&](std::uint32_t, std::uint32_t, double) {
    ++leaves;
    return -1.0;
  });
  CHECK(leaves == 1);
  // Near ones first: the first leaf is item 0, whose distance becomes the limit.
  std::vector<std::uint32_t> seen;
  traverse(bvh, BvhRay(bvh, along), 1e9, [&](std::uint32_t first, std::uint32_t, double) {
    seen.push_back(bvh.order[first]);
    return 1.5;
  });
  CHECK(seen == std::vector<std::uint32_t>{0});
}

TEST_CASE("the hierarchy of the same items is the same every time") {
  Random random(9);
  std::vector<Bounds> items(30'000);
  for (Bounds& b : items) b.add(random.in_cube(10));
  const Bvh first = build_bvh(items, 4);
  for (int i = 0; i < 3; ++i) CHECK(build_bvh(items, 4).order == first.order);
}

TEST_CASE(
    "so many items that they are counted, parted and written side by side give the same for any threads") {
  const std::size_t size = 200'000;  // split() works side by side from 2^16 on
  Random random(4);
  std::vector<Bounds> boxes(size);
  Bounds all;
  for (Bounds& b : boxes) {
    const Vec3 corner = random.in_cube(10);
    b = {corner, corner + Vec3(0.01)};
    all.add(b);
  }
  const auto built = [&](int threads) {
    ThreadBudget budget(threads);
    BvhItems items(all, size, {}, budget, [&](std::size_t i) {
      return std::pair(DoubleLanes::load(boxes[i].min), DoubleLanes::load(boxes[i].max));
    });
    return build_bvh(std::move(items), {4, 8, 1}, budget);
  };
  const Bvh one = built(1);
  CHECK(sorted(one.order) == up_to(size));
  for (const int threads : {2, 5}) {
    const Bvh many = built(threads);
    CHECK(many.order == one.order);
    REQUIRE(many.nodes.size() == one.nodes.size());
    for (std::size_t i = 0; i < one.nodes.size(); ++i) {
      const BvhNode &p = one.nodes[i], &q = many.nodes[i];
      REQUIRE(std::memcmp(p.low, q.low, sizeof p.low) == 0);
      REQUIRE(std::memcmp(p.high, q.high, sizeof p.high) == 0);
      REQUIRE(std::memcmp(p.child, q.child, sizeof p.child) == 0);
      REQUIRE(std::memcmp(p.count, q.count, sizeof p.count) == 0);
    }
  }
  // Each item in the box of its leaf, each node in its parent's box for it.
  int outside = 0;
  for (const BvhNode& node : one.nodes) {
    for (int child = 0; child < bvh_width; ++child) {
      const auto check = [&](int axis, float low, float high) {
        outside += low < node.low[axis][child] || high > node.high[axis][child];
      };
      for (std::uint32_t i = 0; i < node.count[child]; ++i) {
        const Bounds& b = boxes[one.order[node.child[child] + i]];
        for (int axis = 0; axis < 3; ++axis) {
          check(axis, static_cast<float>(b.min[axis] - one.centre[axis]),
                static_cast<float>(b.max[axis] - one.centre[axis]));
        }
      }
      if (node.count[child] != 0 || node.child[child] == 0) continue;
      const BvhNode& below = one.nodes[node.child[child]];
      for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < bvh_width && (below.child[i] != 0 || below.count[i] != 0); ++i) {
          check(axis, below.low[axis][i], below.high[axis][i]);
        }
      }
    }
  }
  CHECK(outside == 0);
}

TEST_CASE("boxes at the end of the range of 32-bit numbers are kept") {
  Random random(6);
  std::vector<Bounds> items(300);
  for (Bounds& b : items) {
    b.add(random.in_cube(3e38));
    b.add(random.in_cube(3e38));
  }
  const Bvh bvh = build_bvh(items, 4);
  CHECK(sorted(bvh.order) == up_to(300));
  for (std::uint32_t item = 0; item < items.size(); ++item) {
    const Vec3 middle = 0.5 * items[item].min + 0.5 * items[item].max;
    CHECK(touched(bvh, ray(middle, {0, 0, 1})).count(item) == 1);
  }
}
