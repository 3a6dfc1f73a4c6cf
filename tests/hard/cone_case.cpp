// Row 7: cones, with the habits of the course's renderer.
#include "geometry/cone.hpp"

#include "tests/hard/batches.hpp"
#include "tests/hard/curved_cases.hpp"
#include "tests/hard/nearby_rays.hpp"
#include "tests/hard/quadric_rays.hpp"
#include "tests/hard/quadric_rules.hpp"

namespace trace::hard {
namespace {

struct Workload {
  const char* name;
  Ray (*ray)(Random&, const RoundShape&);
};

constexpr Workload workloads[] = {{"along the axis", along_axis},
                                  {"1e-1 ... 1e-12 off the axis", almost_along_axis},
                                  {"beside a line of the side", along_generator},
                                  {"on a line of the side", on_generator},
                                  {"through the apex", at_apex},
                                  {"tangent", tangent},
                                  {"at the rim", at_rim},
                                  {"from 1 ... 1e8 away", from_afar}};

// Pointed, blunt, flaring, and nearly a cylinder.
constexpr RoundShape shapes[] = {{1, 1e-4, 1}, {1, 0.5, 2}, {1, 2, 1}, {0.25, 1.5, 4}, {1, 0.998, 1}};

// Slope and apex are rounded quotients: a few ulps of the radius beside those of the ray. Where a ray beside
// a line of the side crosses a rim, its way along the side is 1e3 times and more as long as it is apart, and
// so is the error of t that tells the side from the cap.
constexpr double band = 2e-15, allowed = 1e-11;

// A hit beyond the ends would be one of the mirror nappe, or of nothing.
void note_ends(const RoundShape& shape, const Ray& ray, double t, Row& row) {
  const double z = ray.origin.z + t * ray.direction.z;
  const double slack = band * (2 + std::abs(ray.origin.z) + t);
  if (!(z >= -slack && z <= shape.height + slack)) ++row.wrong;
}

// A ray on a line of the side meets all of it, and rounding decides where: any place on the cone is right.
// The square of the distance to the side, seen from the axis, is off by that of t times its gradient.
void note_surface(const RoundShape& shape, const Ray& ray, double t, Row& row) {
  const ConeShape<Quad> exact(shape.bottom, shape.top, shape.height, true);
  const QuadVec p = QuadRay(ray).at(t);
  const Quad radius = exact.slope * (p.z + exact.apex), square = p.x * p.x + p.y * p.y;
  const Quad reach = 2 + t, slack = 64 * Quad(band) * reach * reach;
  const bool side = magnitude(square - radius * radius) <= slack;
  const bool caps = (magnitude(p.z) <= slack && square <= exact.bottom * exact.bottom + slack) ||
                    (magnitude(p.z - exact.height) <= slack && square <= exact.top * exact.top + slack);
  if (!side && !caps) ++row.wrong;
}

// One ray, judged by the rays around it, or where it is on the side by the place of its hit alone.
void shoot(const RoundShape& shape, bool capped, bool on_side, const Ray& ray, Digest& digest,
           std::vector<Row>& out) {
  const ConeShape<Quad> exact(shape.bottom, shape.top, shape.height, capped);
  const ConeShape<double> rounded(shape.bottom, shape.top, shape.height, capped);
  const auto truth = [&](const QuadRay& r) { return cone_by_the_rules<Quad>(exact, r, 0); };
  LocalHit hit;
  const bool found = Cone(shape.bottom, shape.top, shape.height, capped).intersect(ray, hit);
  digest.add_hit(found, found ? hit.t : 0);
  if (found) note_ends(shape, ray, hit.t, out[0]);
  const auto naive = cone_by_the_rules<double>(rounded, ray, 1e-8);
  if (on_side) {
    ++out[0].rays;
    ++out[1].rays;
    if (found) note_surface(shape, ray, hit.t, out[0]);
    if (naive) note_surface(shape, ray, *naive, out[1]);
  } else {
    note_answer(truth, ray, band, found, hit.t, allowed, out[0]);
    note_answer(truth, ray, band, naive.has_value(), naive.value_or(0), allowed, out[1]);
  }
}

std::vector<Row> run(std::uint64_t rays) {
  std::vector<Row> all;
  std::uint32_t seed = 80;
  for (const Workload& workload : workloads) {
    const auto rows = in_batches(
        rays / std::size(workloads), seed++, {Row(ours, workload.name), Row("textbook", workload.name)},
        [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
          Digest digest;
          for (std::uint64_t i = 0; i < count; ++i) {
            const RoundShape& shape = shapes[random.below(std::size(shapes))];
            const bool capped = random.below(2) == 0;
            shoot(shape, capped, workload.ray == on_generator, workload.ray(random, shape), digest, out);
          }
          out[0].digest = digest.value();
        });
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

HardCase cone_case() {
  return {7,
          "a cone is hit or missed as the course's rules say, along its lines, at its apex and from far away",
          "Along a line of the side the leading coefficient changes sign, and with it which root is the near "
          "one; the line also meets a mirror nappe that is not part of the cone. Truth is the course's own "
          "algorithm in 113 digits, with its habits.",
          14'000,
          1'000'000,
          run};
}

}  // namespace trace::hard
