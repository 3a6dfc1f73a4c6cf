#include "acceleration/mesh_gaps.hpp"

#include <catch2/catch.hpp>

#include "acceleration/mesh_tree.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using trace::test::Random;

namespace {

MeshGap gap(std::uint32_t face, double t, bool on_edge, bool from_behind = false) {
  return {{t, 0.25, 0.25}, face, on_edge, from_behind};
}

}  // namespace

TEST_CASE("a gap strictly within the edges of a face counts by itself") {
  MeshGaps gaps;
  CHECK(gaps.nearest() == nullptr);
  gaps.add(gap(7, 2, false));
  REQUIRE(gaps.nearest());
  CHECK(gaps.nearest()->face == 7);
}

TEST_CASE("a face whose edge is touched exactly counts only with another that faces the same way there") {
  MeshGaps lone;
  lone.add(gap(0, 2, true));
  CHECK(lone.nearest() == nullptr);
  lone.add(gap(1, 3, true));  // elsewhere
  CHECK(lone.nearest() == nullptr);
  lone.add(gap(2, 2, true, true));  // the mesh turns away at this edge
  CHECK(lone.nearest() == nullptr);
  lone.add(gap(0, 2, true));  // the same face once more is no neighbour
  CHECK(lone.nearest() == nullptr);
  lone.add(gap(3, 2 * (1 + 0x1p-50), true));
  REQUIRE(lone.nearest());
  CHECK(lone.nearest()->face == 0);
}

TEST_CASE("two faces seen from behind make a gap as well") {
  MeshGaps gaps;
  gaps.add(gap(4, 1, true, true));
  gaps.add(gap(5, 1, true, true));
  REQUIRE(gaps.nearest());
  CHECK(gaps.nearest()->face == 4);
}

TEST_CASE("of gaps that count the nearest is told, at the same distance the first in the file") {
  MeshGaps gaps;
  gaps.add(gap(9, 5, false));
  gaps.add(gap(8, 4, false));
  gaps.add(gap(3, 4, false));
  gaps.add(gap(1, 3, true));  // does not count
  REQUIRE(gaps.nearest());
  CHECK(gaps.nearest()->face == 3);
}

namespace {

// Two faces that share the edge from point 1 to point 2, and a ray at it.
struct Fold {
  Mesh mesh;
  Ray ray;
};

Fold random_fold(Random& random) {
  Fold fold;
  for (int corner = 0; corner < 3; ++corner) fold.mesh.points.push_back(random.in_cube(1));
  const std::vector<Vec3>& p = fold.mesh.points;
  const Vec3 opposite = p[1] + p[2] - p[0] + random.in_cube(0.1);
  fold.mesh.points.push_back(opposite);
  fold.mesh.faces = {{0, 1, 2}, {3, 2, 1}};
  const Vec3 target = p[1] + random.between(0.1, 0.9) * (p[2] - p[1]);
  const Vec3 origin = target + 3.0 * random.in_cube(1);
  fold.ray = {origin, glm::normalize(target - origin)};
  return fold;
}

bool closest(const Fold& fold, LocalHit& hit) {
  return MeshTree(fold.mesh).closest(fold.ray, 100, false, hit);
}

// Those whose ray neither face accepts by the course's form.
std::vector<Fold> folds_with_gap() {
  Random random(5);
  std::vector<Fold> found;
  for (int i = 0; i < 2'000; ++i) {
    const Fold fold = random_fold(random);
    LocalHit hit;
    if (closest(fold, hit) && hit.is_gap) found.push_back(fold);
  }
  return found;
}

// A face around the shared edge, in the plane of the first face moved by `offset`; the third in the file.
void add_cover(Mesh& mesh, const Vec3& offset) {
  const Vec3 from = mesh.points[1] + offset, along = mesh.points[2] - mesh.points[1],
             across = mesh.points[0] - mesh.points[1];
  for (const Vec3& corner : {-along - across, 2.0 * along - across, 3.0 * across}) {
    mesh.points.push_back(from + corner);
  }
  mesh.faces.push_back({4, 5, 6});
}

}  // namespace

TEST_CASE("a gap between two faces of a mesh is closed, marked, and in the way of light") {
  const std::vector<Fold> folds = folds_with_gap();
  REQUIRE(folds.size() > 50);
  for (const Fold& fold : folds) {
    LocalHit hit;
    REQUIRE(closest(fold, hit));
    const Vec3 edge = glm::normalize(fold.mesh.points[2] - fold.mesh.points[1]);
    const Vec3 from_edge = fold.ray.at(hit.t) - fold.mesh.points[1];
    CHECK(glm::length(glm::cross(from_edge, edge)) < 1e-9);
    CHECK(MeshTree(fold.mesh).occludes(fold.ray, 1, 100));
    CHECK_FALSE(MeshTree(fold.mesh).occludes(fold.ray, 1, 0.5 * hit.t));
  }
}

TEST_CASE("what is hit at the place of a gap is the answer, and the gap is none") {
  int covered = 0, other = 0;
  for (Fold fold : folds_with_gap()) {
    add_cover(fold.mesh, Vec3(0));
    LocalHit hit;
    REQUIRE(closest(fold, hit));
    hit.part == 2 && !hit.is_gap ? ++covered : ++other;
  }
  CHECK(covered > 50);
  CHECK(other == 0);
}

TEST_CASE("a gap hides what is beyond it") {
  int hidden = 0, shown = 0;
  for (Fold fold : folds_with_gap()) {
    add_cover(fold.mesh, 1e-3 * fold.ray.direction);
    LocalHit hit;
    REQUIRE(closest(fold, hit));
    hit.part < 2 && hit.is_gap ? ++hidden : ++shown;
  }
  CHECK(hidden > 50);
  CHECK(shown == 0);
}
