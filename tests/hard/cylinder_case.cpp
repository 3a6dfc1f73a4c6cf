// Row 7: cylinders.
#include "geometry/cylinder.hpp"

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
                                  {"tangent", tangent},
                                  {"at the rim", at_rim},
                                  {"from 1 ... 1e8 away", from_afar}};

// Nine roundings of the coordinates of origin and direction go into the stable form of the discriminant.
// t: as for the sphere.
constexpr double band = 1e-15, allowed = 1e-12;

std::vector<Row> run(std::uint64_t rays) {
  std::vector<Row> all;
  std::uint32_t seed = 70;
  for (const Workload& workload : workloads) {
    const auto rows = in_batches(
        rays / std::size(workloads), seed++, {Row(ours, workload.name), Row("textbook", workload.name)},
        [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
          const auto truth = [](const QuadRay& ray) { return cylinder_by_the_rules<Quad>(ray, 0); };
          Digest digest;
          for (std::uint64_t i = 0; i < count; ++i) {
            const Ray ray = workload.ray(random, {1, 1, 1});
            LocalHit hit;
            const bool found = Cylinder{}.intersect(ray, hit);
            digest.add_hit(found, found ? hit.t : 0);
            note_answer(truth, ray, band, found, hit.t, allowed, out[0]);
            const auto naive = cylinder_by_the_rules<double>(ray, 1e-8);
            note_answer(truth, ray, band, naive.has_value(), naive.value_or(0), allowed, out[1]);
          }
          out[0].digest = digest.value();
        });
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

HardCase cylinder_case() {
  return {7,
          "a cylinder is hit or missed as its line says, along the axis, at the rim and from far away",
          "Along the axis the leading coefficient vanishes, and from far away the discriminant cancels as a "
          "sphere's does. The side is decided by the distance of the line to the axis, the caps by planes.",
          10'000,
          1'000'000,
          run};
}

}  // namespace trace::hard
