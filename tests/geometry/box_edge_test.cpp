// Rays through two edges of a box, which rounding can put beside all of its faces.
#include "geometry/box.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/quad.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// On one of the four edges along `axis`.
Vec3 on_edge(Random& random, int axis) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) p[i] = i == axis ? random.between(-0.5, 0.5) : random.below(2) - 0.5;
  return p;
}

// From outside through a point of an edge and one of the edge across the box.
Ray through_two_edges(Random& random) {
  const int axis = static_cast<int>(random.below(3));
  const Vec3 in = on_edge(random, axis);
  Vec3 out = -in;
  out[axis] = random.between(-0.5, 0.5);
  const Vec3 origin = in + random.between(0.1, 20) * (in - out);
  return {origin, glm::normalize(out - in)};
}

struct Chord {
  Quad enter = -1e30, leave = 1e30;
};

// The exact part of the ray's line between all three pairs of planes.
Chord chord(const Ray& ray) {
  Chord result;
  for (int axis = 0; axis < 3; ++axis) {
    const Quad o = ray.origin[axis], d = ray.direction[axis], side = d > 0 ? Quad(0.5) : Quad(-0.5);
    const Quad in = (-side - o) / d, out = (side - o) / d;
    if (in > result.enter) result.enter = in;
    if (out < result.leave) result.leave = out;
  }
  return result;
}

}  // namespace

TEST_CASE(
    "a ray that crosses a box through its edges hits it, also where rounding puts it beside all faces") {
  Random random(3);
  int missed = 0, wrong = 0, inward = 0, gaps = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Ray ray = through_two_edges(random);
    const Chord truth = chord(ray);
    if (!(truth.leave - truth.enter > Quad(1e-9))) continue;
    LocalHit hit;
    if (!Box{}.intersect(ray, hit)) {
      ++missed;
      continue;
    }
    const bool at_end =
        magnitude(hit.t - truth.enter) < Quad(1e-13) || magnitude(hit.t - truth.leave) < Quad(1e-13);
    if (!at_end) ++wrong;
    if (!hit.is_gap) continue;
    ++gaps;
    if (magnitude(hit.t - truth.enter) < Quad(1e-13) && glm::dot(hit.normal, ray.direction) < 0) ++inward;
  }
  CHECK(missed == 0);
  CHECK(wrong == 0);
  CHECK(gaps > 0);
  CHECK(inward == gaps);  // where the ray comes in
}

TEST_CASE("a ray beside an edge of a box misses it, however long it runs there") {
  const double beside = GENERATE(1e-15, 1e-9, 1e-3);
  LocalHit hit;
  CHECK_FALSE(Box{}.intersect({{0.5 + beside, 0.25, 3}, {0, 0, -1}}, hit));
  // Past the edge x = y = 1/2 by `beside` in x.
  CHECK_FALSE(Box{}.intersect({{2 + beside, -1, 0}, Vec3(-1, 1, 0)}, hit));
}
