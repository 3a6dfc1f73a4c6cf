#include "tests/hard/watertight_cases.hpp"

#include <optional>

#include "acceleration/mesh_tree.hpp"
#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/closed_meshes.hpp"
#include "tests/hard/crossings.hpp"
#include "tests/hard/embree_mesh.hpp"
#include "tests/hard/textbook_triangle.hpp"

namespace trace::hard {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A closed mesh, placed, and where to look from in the space before it is placed.
struct Shell {
  std::string name;
  Mesh mesh;
  Vec3 (*eye)(Random&);
  double scale = 1;
  Vec3 offset{0};
  bool for_embree = true;  // it still is a closed surface around its eyes once its numbers are floats
};

Vec3 in_ball(Random& random) {
  const Vec3 towards = unit_vector(random);
  return 0.5 * fraction(random) * towards;
}
// Flat solids keep their eyes near the middle.
Vec3 in_middle(Random& random) {
  return 1e-7 * random.in_cube(1);
}
Vec3 in_tube(Random& random) {
  const double turn = random.between(0, 6.283), radius = 1 + random.between(-0.2, 0.2);
  return {radius * std::cos(turn), radius * std::sin(turn), random.between(-0.2, 0.2)};
}

std::vector<Shell> shells() {
  std::vector<Shell> all;
  all.push_back({"sphere of 2 304 faces", sphere_mesh(24, 48), in_ball});
  all.push_back({"torus of 1 152 faces", torus_mesh(36, 16), in_tube});
  all.push_back({"slivers of aspect 1e6", sliver_sphere_mesh(8, 16, 4e-7), in_ball});
  all.push_back({"sphere flattened by 1e6", placed(sphere_mesh(12, 24), {1, 1, 1e-6}, Vec3(0)), in_middle});
  all.push_back({"1 000 triangles in a corner", double_cone_mesh(1000),
                 [](Random& random) { return 0.3 * in_ball(random); }});
  for (const int power : {-9, -6, -3, 3, 6, 9}) {
    const double factor = std::pow(10, power);
    all.push_back({"scaled by 1e" + std::to_string(power), placed(sphere_mesh(8, 16), Vec3(factor), Vec3(0)),
                   in_ball, factor});
  }
  for (const int power : {3, 5, 7, 9}) {
    const double factor = std::pow(10, power);
    const Vec3 offset = factor * Vec3(0.71, -0.37, 0.93);
    all.push_back({"moved by 1e" + std::to_string(power), placed(sphere_mesh(8, 16), Vec3(1), offset),
                   in_ball, 1, offset, factor <= 1e3});
  }
  const Vec3 far = 1e6 * Vec3(0.71, -0.37, 0.93);
  all.push_back({"torus moved by 1e6", placed(torus_mesh(18, 8), Vec3(1), far), in_tube, 1, far, false});
  return all;
}

void note_error(Row& row, const Mesh& mesh, const Ray& ray, const FaceHit& hit) {
  const double t = plane_t(ray, mesh.corners(hit.face));
  row.note_error(std::abs(hit.t - t) / std::abs(t));
}

// All faces in turn, by one form of the predicate.
void count_crossings(Row& row, const Shell& shell, const Crossings& crossings, const Ray& ray,
                     const std::vector<FaceHit>& hits) {
  ++row.rays;
  if (hits.empty()) {
    ++row.misses;
    return;
  }
  const Crossings::Count count = crossings.count(ray, hits);
  if (!count.sound || (count.certain && count.crossings % 2 == 0)) ++row.parity;
  for (const FaceHit& hit : hits) note_error(row, shell.mesh, ray, hit);
}

std::vector<Row> look_out_of(const Shell& shell, std::uint64_t rays, std::uint32_t seed) {
  const MeshTree tree(shell.mesh);
  const Crossings crossings(shell.mesh);
  std::optional<EmbreeMesh> embree;
  std::vector<Row> names{Row(ours, shell.name), Row("textbook", shell.name)};
  if (embree_is_here && shell.for_embree) {
    embree.emplace(shell.mesh);
    names.emplace_back("Embree 3 robust", shell.name);
  }
  return in_batches(rays, seed, names, [&](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
    Digest digest;
    std::vector<FaceHit> hits;
    for (std::uint64_t i = 0; i < in_batch; ++i) {
      const Vec3 eye = shell.scale * shell.eye(random) + shell.offset;
      const Ray ray = aimed_at_edges(random, shell.mesh, eye);

      all_hits(shell.mesh, ray, hits);
      count_crossings(rows[0], shell, crossings, ray, hits);
      LocalHit nearest;
      const bool found = tree.closest(ray, infinity, false, nearest);
      if (!hits.empty() && !found) ++rows[0].misses;
      digest.add_hit(found ? nearest.part : ~0u, found ? nearest.t : 0);

      textbook_hits(shell.mesh, ray, hits);
      count_crossings(rows[1], shell, crossings, ray, hits);

      if (!embree) continue;
      FaceHit hit;
      ++rows[2].rays;
      if (!embree->closest(ray, hit)) {
        ++rows[2].misses;
      } else {
        note_error(rows[2], embree->rounded(), EmbreeMesh::rounded(ray), hit);
      }
    }
    rows[0].digest = digest.value();
  });
}

std::vector<Row> run(std::uint64_t rays) {
  std::vector<Row> rows;
  const std::vector<Shell> all = shells();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (Row& row : look_out_of(all[i], rays / all.size(), static_cast<std::uint32_t>(100 + i))) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace

HardCase watertight_case() {
  return {1,
          "no ray from inside a closed mesh gets out between its triangles",
          "Rays are aimed at edges and corners and up to 64 ulps beside them, where both triangles of an "
          "edge may round "
          "to a miss; random rays never find such cracks. Where an edge value is within its error bound of "
          "zero its sign "
          "is decided exactly, the same for both triangles, so that the ray crosses exactly once.",
          10'000,
          10'240'000,
          run};
}

}  // namespace trace::hard
