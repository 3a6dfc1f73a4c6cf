#include "tests/hard/exact.hpp"

#include <catch2/catch.hpp>

#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/random_bits.hpp"

using namespace trace;
using namespace trace::hard;

namespace {

const Ray along_z{{0, 0, 0}, {0, 0, 1}};

}  // namespace

TEST_CASE("the exact sign of an edge is that of the plane's determinant, down to the last ulp") {
  // Seen along z the value is px qy - py qx. 1 + e and 1 - e: the product is 1 - e^2, which doubles round
  // to 1.
  constexpr double e = 0x1p-52;
  CHECK(edge_sign(along_z, {1 + e, 1, 5}, {1, 1 - e, 7}) == -1);
  CHECK(edge_sign(along_z, {1, 1, 5}, {1 + e, 1 + e, 7}) == 0);
  CHECK(edge_sign(along_z, {1, 1 - e, 5}, {1 + e, 1, 7}) == 1);
  // The published example of cancellation: -75.2 where floats say -128.
  CHECK(edge_sign(along_z, {33962.035f, 41563.4f, 1}, {-24871.969f, -30438.8f, 1}) == -1);
}

TEST_CASE("zeros and the smallest and largest of numbers have exact signs") {
  constexpr double tiny = 0x1p-1074, huge = 0x1p1023;
  CHECK(edge_sign(along_z, {tiny, 0, 1}, {0, tiny, 1}) == 1);
  CHECK(edge_sign(along_z, {huge, 0, 1}, {0, -huge, 1}) == -1);
  CHECK(edge_sign(along_z, {huge, tiny, 1}, {huge, tiny, 3}) == 0);
  CHECK(edge_sign(along_z, {huge, tiny, 1}, {huge, 2 * tiny, 3}) == 1);
  CHECK(edge_sign(along_z, {0, 0, 1}, {1, 2, 3}) == 0);
  CHECK(edge_sign({{huge, huge, 0}, {0, 0, 1}}, {huge, -huge, 1}, {-huge, huge, 1}) == -1);
}

TEST_CASE("an exact sign turns with the order of the edge, for numbers of any bits") {
  Random random(1);
  const auto any = [&] { return Vec3{random_bits(random), random_bits(random), random_bits(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{any(), any()};
    const Vec3 p = any(), q = any();
    CHECK(edge_sign(ray, p, q) == -edge_sign(ray, q, p));
    CHECK(edge_sign(ray, p, p) == 0);
    CHECK(edge_sign(ray, ray.origin, q) == 0);
  }
}

TEST_CASE("a line through an edge or a corner hits, one beside it does not, one in the plane does not") {
  const Corners triangle{{0, 0, 4}, {1, 0, 4}, {0, 1, 4}};
  const auto hits = [&](double x, double y) { return line_hits({{x, y, 0}, {0, 0, 1}}, triangle); };
  CHECK(hits(0.25, 0.25));
  CHECK(hits(0.5, 0));
  CHECK(hits(0, 0));
  CHECK(hits(0.5, 0.5));
  CHECK_FALSE(hits(0.5, -0x1p-1074));
  CHECK_FALSE(hits(0.5 + 0x1p-53, 0.5));
  CHECK_FALSE(line_hits({{-1, 0.25, 4}, {1, 0, 0}}, triangle));
  CHECK(plane_t({{0.25, 0.25, 1}, {0, 0, 2}}, triangle) == 1.5);
}
