#include <catch2/catch.hpp>

#include "acceleration/bvh_build.hpp"

using namespace trace;

TEST_CASE("the surface-area cost counts nodes and items by their share of the root's surface") {
  CHECK(surface_area_cost(build_bvh({}, 4)) == 0);
  // The root, and one leaf of its size with one item.
  const std::vector<Bounds> one{{Vec3(-1), Vec3(1)}};
  CHECK(surface_area_cost(build_bvh(one, 4)) == Approx(2));
  // Two unit cubes at the ends of a bar of 10: the root and two leaves, of 6 each of its 42.
  const std::vector<Bounds> two{{Vec3(0), Vec3(1)}, {Vec3(9, 0, 0), Vec3(10, 1, 1)}};
  CHECK(surface_area_cost(build_bvh(two, 1)) == Approx(1 + 12.0 / 42));
}

TEST_CASE("a leaf costs as many blocks as its items fill, the last one in part") {
  // One leaf of the root's size with six items.
  const std::vector<Bounds> six(6, Bounds{Vec3(-1), Vec3(1)});
  const Bvh bvh = build_bvh(six, 6);
  CHECK(surface_area_cost(bvh) == Approx(1 + 6));
  CHECK(surface_area_cost(bvh, 4) == Approx(1 + 2));
  CHECK(surface_area_cost(bvh, 6) == Approx(1 + 1));
  CHECK(surface_area_cost(bvh, 8) == Approx(1 + 1));
}
