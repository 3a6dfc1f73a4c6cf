#include "tests/hard/batches.hpp"
#include "tests/hard/leaving_cases.hpp"
#include "tests/hard/solids.hpp"
#include "tests/hard/textbook_leaving.hpp"

namespace trace::hard {
namespace {

constexpr double gap = 1e-6;  // of the size
constexpr double infinity = std::numeric_limits<double>::infinity();

// In its own space: a ground whose highest point, or plane, is at z = 0, and a square of side 0.5 at z = gap
// above it.
void add_ground(Scene& scene, SolidKind kind, const Mat4& place) {
  switch (kind) {
    case SolidKind::sphere:
      test::add(scene, Sphere{}, place * test::moved(0, 0, -1), Material{});
      break;
    case SolidKind::box:
      test::add(scene, Box{}, place * test::moved(0, 0, -0.5), Material{});
      break;
    case SolidKind::square:
      test::add(scene, Square{}, place, Material{});
      break;
    case SolidKind::cylinder:
      test::add(scene, Cylinder{}, place * test::moved(0, 0, -1), Material{});
      break;
    case SolidKind::cone:
      test::add(scene, Cone(1, 0.5, 1, true), place * test::moved(0, 0, -1), Material{});
      break;
    case SolidKind::mesh: {
      Mesh mesh;
      mesh.points = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
      mesh.faces = {{0, 1, 2}, {0, 2, 3}};
      test::add(scene, mesh, place, Material{});
    }
  }
}

void add_occluder(Scene& scene, bool as_mesh, const Mat4& place) {
  const Mat4 above = place * test::moved(0, 0, gap) * test::scaled(0.5);
  add_ground(scene, as_mesh ? SolidKind::mesh : SolidKind::square, above);
}

void shoot(Row& trace, Row& fixed, Digest& digest, Random& random, double offset) {
  const double size = std::pow(10, random.between(-8, std::min(8.0, 8 - std::log10(std::max(offset, 1.0)))));
  const Vec3 away = offset * size * unit_vector(random);
  const Mat4 place = glm::translate(Mat4(1), away) * random_turn(random) * test::scaled(size);
  const auto kind = static_cast<SolidKind>(random.below(solid_kinds));
  Scene ground, both;
  add_ground(ground, kind, place);
  add_ground(both, kind, place);
  add_occluder(both, random.below(2) == 0, place);
  const SceneTree ground_tree(ground), tree(both);

  for (int i = 0; i < 8; ++i) {
    // The sphere falls away from the plane above it by r^2 / 2.
    const double reach = kind == SolidKind::sphere ? 1e-4 : 0.1;
    const Vec3 target(place * Vec4{reach * random.between(-1, 1), reach * random.between(-1, 1), 0, 1});
    const Vec3 eye(place * Vec4{random.between(-2, 2), random.between(-2, 2), 3, 1});
    const Ray primary{eye, glm::normalize(target - eye)};
    const Hit hit = ground_tree.closest(primary, false);
    // The course's cone is not met by rays that pass through its caps alone.
    if (!hit && kind == SolidKind::cone) continue;
    ++trace.rays;
    if (!hit) {
      ++trace.misses;
      continue;
    }
    // At least 30 degrees above the ground: under the occluder for 2e-6 of the size or less.
    const double turn = random.between(0, 6.283), height = random.between(0.5, 1);
    const double out = std::sqrt(1 - height * height);
    const Vec3 up = glm::normalize(Mat3(place) * Vec3(out * std::cos(turn), out * std::sin(turn), height));
    const Ray shadow = leaving(ground, primary, hit, up);
    const Hit first = tree.closest(shadow, false);
    if (!tree.occluded(shadow, infinity) || !first) {
      ++trace.misses;
    } else if (first.object != 1) {
      ++trace.self_hits;
    }
    digest.add_hit(first ? first.object : ~0u, first ? first.t : 0);
    // The same ray with a fixed epsilon in the world, as most programs have it: lost where the way to the
    // occluder is shorter, whatever else happens.
    ++fixed.rays;
    if (gap * size / height < textbook_epsilon) ++fixed.misses;
  }
}

std::vector<Row> run(std::uint64_t rays) {
  constexpr std::string_view fixed = "fixed epsilon 1e-8";
  constexpr std::string_view workloads[] = {"at the origin", "moved by 1e3 sizes", "moved by 1e6 sizes",
                                            "moved by 1e7 sizes"};
  constexpr double offsets[] = {0, 1e3, 1e6, 1e7};
  std::vector<Row> names;
  for (const std::string_view workload : workloads) {
    names.emplace_back(ours, workload);
    names.emplace_back(fixed, workload);
  }
  return in_batches(rays / 8, 55, names, [&](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
    std::vector<Digest> digests(4);
    for (std::uint64_t i = 0; i < in_batch; ++i) {
      const std::size_t w = i % 4;
      shoot(rows[2 * w], rows[2 * w + 1], digests[w], random, offsets[w]);
    }
    for (std::size_t w = 0; w < 4; ++w) rows[2 * w].digest = digests[w].value();
  });
}

}  // namespace

HardCase contact_case() {
  return {5,
          "what is 1e-6 of its size above a surface keeps its shadow, at every scale",
          "A wide epsilon that hides self-hits also swallows what truly lies close: contact shadows. Sizes "
          "are 1e-8 to 1e8, "
          "moved by up to 1e7 times as much, where the gap is some hundred ulps of the coordinates.",
          24'000,
          4'000'000,
          run};
}

}  // namespace trace::hard
