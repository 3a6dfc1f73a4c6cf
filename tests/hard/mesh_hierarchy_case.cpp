#include <optional>

#include "acceleration/mesh_tree.hpp"
#include "tests/hard/adapters.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/hierarchy_cases.hpp"
#include "tests/hard/random_bits.hpp"

namespace trace::hard {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Points are drawn by `point`, faces between any three of them.
template <class Point>
Mesh random_mesh(Random& random, Point&& point) {
  Mesh mesh;
  const std::uint32_t points = 3 + random.below(30);
  for (std::uint32_t i = 0; i < points; ++i) mesh.points.push_back(point());
  while (mesh.faces.size() < 40) {
    mesh.faces.push_back({random.below(points), random.below(points), random.below(points)});
  }
  return mesh;
}

Mesh draw_mesh(Random& random, int kind) {
  switch (kind) {
    case 0:
      return random_mesh(random, [&] { return random.in_cube(2); });
    case 1: {  // flat, on a line, or in few places
      const Vec3 along = random.in_cube(1), offset = random.on_grid(2, 1);
      const bool line = random.below(2) == 0;
      return random_mesh(random, [&]() -> Vec3 {
        return line ? offset + random.between(-1, 1) * along : offset + random.in_cube(1) * Vec3(1, 1, 0);
      });
    }
    case 2:
      return random_mesh(random, [&] { return random.on_grid(2, 0.5); });
    case 3:
      return random_mesh(random, [&] {
        return Vec3{random_bits(random, 30), random_bits(random, 30), random_bits(random, 30)};
      });
    default:
      return random_mesh(random, [&] {
        return Vec3{random_bits(random), random_bits(random), random_bits(random)};
      });
  }
}

// Through a point of a face where that can be told; else from and to anywhere.
Ray draw_ray(Random& random, const Mesh& mesh, int kind) {
  if (kind == 2) {
    // In planes and along lines of the grid, with zeros of either sign.
    const Vec3 origin = random.on_grid(8, 0.25);
    Vec3 step(0);
    while (step == Vec3(0)) step = random.on_grid(1, random.below(2) == 0 ? 1 : -1);
    return {origin, glm::normalize(step)};
  }
  const Corners c = mesh.corners(random.below(static_cast<std::uint32_t>(mesh.faces.size())));
  const double u = random.below(3) == 0 ? 0 : fraction(random),
               v = random.below(3) == 0 ? 0 : fraction(random);
  const Vec3 target = c.a + u * (c.b - c.a) + v * (1 - u) * (c.c - c.a);
  Vec3 origin = random.in_cube(4);
  if (kind == 3) origin = {random_bits(random, 30), random_bits(random, 30), random_bits(random, 30)};
  if (kind == 4) origin = {random_bits(random), random_bits(random), random_bits(random)};
  Vec3 direction = target - origin;
  const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  direction =
      largest > 0 && std::isfinite(largest) ? glm::normalize(direction / largest) : unit_vector(random);
  return {origin, is_finite(direction) ? direction : unit_vector(random)};
}

std::vector<Row> run(std::uint64_t rays) {
  const std::vector<Row> names{Row(ours, "random"), Row(ours, "without area or on a line"),
                               Row(ours, "on a grid, upright"), Row(ours, "exponents within 30"),
                               Row(ours, "any bits")};
  return in_batches(rays, 3, names, [](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
    std::vector<Digest> digests(rows.size());
    Mesh mesh;
    std::optional<MeshTree> tree;
    for (std::uint64_t i = 0; i < in_batch; ++i) {
      // The last two kinds are decided by exact arithmetic most of the time, and take as long as all others.
      constexpr std::size_t kinds[] = {0, 1, 2, 0, 1, 2, 0, 2, 3, 0, 2, 4};
      const std::size_t kind = kinds[i / 64 % std::size(kinds)];
      if (i % 64 == 0) {
        mesh = draw_mesh(random, static_cast<int>(kind));
        tree.emplace(mesh);
      }
      const Ray ray = draw_ray(random, mesh, static_cast<int>(kind));
      LocalHit truth, found;
      const bool expected = test::nearest_face(mesh, ray, false, truth);
      const bool any = tree->closest(ray, infinity, false, found);
      Row& row = rows[kind];
      ++row.rays;
      if (any != expected) {
        ++(any ? row.wrong : row.misses);
      } else if (any && (found.part != truth.part ||
                         std::bit_cast<std::uint64_t>(found.t) != std::bit_cast<std::uint64_t>(truth.t))) {
        ++row.wrong;
      }
      digests[kind].add_hit(any ? found.part : ~0u, any ? found.t : 0);
    }
    for (std::size_t kind = 0; kind < rows.size(); ++kind) rows[kind].digest = digests[kind].value();
  });
}

}  // namespace

HardCase mesh_hierarchy_case() {
  return {3,
          "the hierarchy of a mesh finds the face and the t of testing every face, bit for bit",
          "Faces without area, on lines, on grids and of random bits have boxes without thickness, of huge "
          "size or with "
          "corners beyond the range of floats. Boxes are rounded outward and both ends of a slab are padded "
          "by the bound "
          "of their error, and of equal hits the first in the file counts.",
          20'000,
          10'000'000,
          run};
}

}  // namespace trace::hard
