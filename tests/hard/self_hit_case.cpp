#include "tests/hard/batches.hpp"
#include "tests/hard/leaving_cases.hpp"
#include "tests/hard/solids.hpp"
#include "tests/hard/textbook_leaving.hpp"

namespace trace::hard {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Into the half-space of `normal`; in half of the cases within 1e-1 ... 1e-9 of the surface.
Vec3 to_one_side(Random& random, const Vec3& normal) {
  Vec3 direction = unit_vector(random);
  double up = glm::dot(direction, normal);
  if (random.below(2) == 0) {
    const Vec3 along = direction - up * normal;
    if (glm::dot(along, along) < 1e-4) return normal;
    up = std::pow(10, random.between(-9, -1));
    direction = glm::normalize(glm::normalize(along) + up * normal);
  }
  return up > 0 ? direction : -direction;
}

// How far an inward ray goes within the solid from where it was touched, in the object's space; of the shapes
// whose far side cannot be missed. 0 where it cannot be told.
double inside_length(const Shape& shape, const Touch& at, const Vec3& d) {
  const Vec3& p = at.local;
  if (std::holds_alternative<Sphere>(shape)) return -2 * glm::dot(p, d);
  if (std::holds_alternative<Box>(shape)) {
    double leave = infinity;
    for (int axis = 0; axis < 3; ++axis) {
      if (d[axis] != 0) leave = std::min(leave, (std::copysign(0.5, d[axis]) - p[axis]) / d[axis]);
    }
    return leave;
  }
  if (std::holds_alternative<Cylinder>(shape)) {
    const double a = d.x * d.x + d.y * d.y, b = p.x * d.x + p.y * d.y;
    const double around =
        a > 0 ? (-b + std::sqrt(std::max(0.0, b * b - a * (p.x * p.x + p.y * p.y - 1)))) / a : infinity;
    const double along = d.z != 0 ? ((d.z > 0 ? 1 : 0) - p.z) / d.z : infinity;
    return std::min(around, along);
  }
  if (std::holds_alternative<MeshId>(shape)) {
    // The ball within the icosahedron, of radius 1.51, holds a chord at least as long as this.
    const double b = -glm::dot(p, d), squared = 1.5 * 1.5 - glm::dot(p, p) + b * b;
    return squared > 0 ? b + std::sqrt(squared) : 0;
  }
  return 0;
}

// Whether a point is in the solid by more than any error of a place; of a ray that runs along a face, at the
// edge of which it starts, rounding says on which side.
bool is_well_inside(const Shape& shape, const Vec3& p) {
  constexpr double margin = 1e-6;
  if (std::holds_alternative<Box>(shape)) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 0.5 - margin;
  }
  if (std::holds_alternative<Cylinder>(shape)) {
    return p.x * p.x + p.y * p.y < 1 - margin && p.z > margin && p.z < 1 - margin;
  }
  return true;
}

struct Counts {
  Row &trace, &textbook;
  Digest& digest;
};

void leave_outward(Counts counts, Random& random, const Solid& solid, const SceneTree& tree, const Touch& at,
                   bool has_textbook) {
  const Vec3 direction = to_one_side(random, at.outward);
  const Ray ray = leaving(solid.scene, at.ray, at.hit, direction);
  ++counts.trace.rays;
  const Hit again = tree.closest(ray, false);
  if (again || tree.occluded(ray, infinity)) ++counts.trace.self_hits;
  counts.digest.add_hit(bool(again), again ? again.t : 0);
  if (!has_textbook) return;
  ++counts.textbook.rays;
  const ObjectRay local(solid.scene.frames[0], {at.ray.at(at.hit.t), direction});
  if (textbook_hits(solid.scene, solid.scene.objects[0].shape, local.ray)) ++counts.textbook.self_hits;
}

void go_inward(Counts counts, Random& random, const Solid& solid, const SceneTree& tree, const Touch& at,
               bool has_textbook) {
  const Vec3 direction = to_one_side(random, -at.outward);
  const ObjectRay local(solid.scene.frames[0], {at.ray.at(at.hit.t), direction});
  const Shape& shape = solid.scene.objects[0].shape;
  // Where the way through is short, or the ray hardly leaves the surface, rounding may rightly lose it.
  const double length = inside_length(shape, at, local.ray.direction);
  if (-glm::dot(direction, at.outward) < 1e-3 || !(length > 1e-2)) return;
  if (!is_well_inside(shape, at.local + 0.5 * length * local.ray.direction)) return;
  const Ray ray = leaving(solid.scene, at.ray, at.hit, direction);
  ++counts.trace.rays;
  const Hit far = tree.closest(ray, false);
  // At least half the way: not the place that it left.
  if (!far) {
    ++counts.trace.misses;
  } else if (far.local.t < 0.5 * length) {
    ++counts.trace.self_hits;
  }
  counts.digest.add_hit(bool(far), far ? far.t : 0);
  if (!has_textbook) return;
  ++counts.textbook.rays;
  if (!textbook_hits(solid.scene, shape, local.ray)) ++counts.textbook.misses;
}

std::vector<Row> run_kind(SolidKind kind, std::uint64_t rays) {
  const std::string name(name_of(kind));
  std::vector<Row> names{Row(ours, name)};
  const bool has_textbook = kind != SolidKind::cylinder && kind != SolidKind::cone;
  if (has_textbook) names.emplace_back("fixed epsilon 1e-8", name);
  return in_batches(rays, 500 + static_cast<std::uint32_t>(kind), names,
                    [&](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
                      Digest digest;
                      Row unused("");
                      const Counts counts{rows[0], has_textbook ? rows[1] : unused, digest};
                      while (rows[0].rays < in_batch) {
                        const Solid solid = random_solid(random, kind);
                        const SceneTree tree(solid.scene);
                        for (int i = 0; i < 8; ++i) {
                          const std::optional<Touch> at = touch(random, solid, tree);
                          for (int j = 0; at && j < 4; ++j) {
                            leave_outward(counts, random, solid, tree, *at, has_textbook);
                            go_inward(counts, random, solid, tree, *at, has_textbook);
                          }
                        }
                        // A form that hits nothing at all has no rays to send on.
                        if (rows[0].rays == 0) ++rows[0].misses, ++rows[0].rays;
                      }
                      rows[0].digest = digest.value();
                    });
}

std::vector<Row> run(std::uint64_t rays) {
  std::vector<Row> rows;
  for (int kind = 0; kind < solid_kinds; ++kind) {
    for (Row& row : run_kind(static_cast<SolidKind>(kind), rays / solid_kinds))
      rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

HardCase self_hit_case() {
  return {5,
          "a ray that leaves a convex solid does not meet it again, and one that enters meets its far side",
          "The computed point lies beside the surface by an error that grows with the distance from the "
          "origin and shrinks "
          "with nothing, so that a fixed epsilon is too small on large and far scenes and too large on tiny "
          "ones. Each "
          "secondary ray carries the measured error of its origin, and a hit is dropped exactly where the "
          "origin cannot "
          "be told from a point of what is hit.",
          100'000,
          100'000'000,
          run};
}

}  // namespace trace::hard
