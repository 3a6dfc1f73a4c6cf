// Row 7: tori.
#include "geometry/torus.hpp"

#include "tests/hard/batches.hpp"
#include "tests/hard/curved_cases.hpp"
#include "tests/hard/nearby_rays.hpp"
#include "tests/hard/torus_truth.hpp"

namespace trace::hard {
namespace {

struct Workload {
  const char* name;
  Ray (*ray)(Random&, const RingShape&);
};

constexpr Workload workloads[] = {{"touching", touching},
                                  {"touching in the lines of no curvature", touching_inside},
                                  {"along the axis", beside_axis},
                                  {"in the plane of symmetry", in_plane},
                                  {"from 1 ... 1e8 away", at_ring_from_afar},
                                  {"from inside", from_inside}};

// Rings, thin ones, a horn torus and a spindle.
constexpr RingShape shapes[] = {{1, 0.2}, {0.9, 0.3}, {1, 0.001}, {30, 0.01}, {1, 1}, {1, 1.5}};

// Coordinates near the torus are rounded a few times in the height that decides.
constexpr double band = 4e-15, allowed = 1e-12;

// What geometry/torus.hpp says of a hit's place.
void note_place(const RingShape& shape, const Ray& ray, double t, Row& row) {
  const Quad off = magnitude(height_above(shape, QuadRay(ray).at(t)));
  if (!(off <= Quad(16 * 0x1p-53) * (Quad(shape.reach()) + Quad(t)))) ++row.wrong;
}

std::vector<Row> run(std::uint64_t rays) {
  std::vector<Row> all;
  std::uint32_t seed = 170;
  for (const Workload& workload : workloads) {
    const auto rows = in_batches(
        rays / std::size(workloads), seed++, {Row(ours, workload.name), Row("textbook", workload.name)},
        [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
          Digest digest;
          for (std::uint64_t i = 0; i < count; ++i) {
            const RingShape& shape = shapes[random.below(std::size(shapes))];
            const Ray ray = workload.ray(random, shape);
            const auto truth = [&](const QuadRay& r) { return true_torus(shape, r); };
            LocalHit hit;
            const bool found = Torus(shape.major, shape.minor).intersect(ray, hit);
            digest.add_hit(found, found ? hit.t : 0);
            note_answer(truth, ray, band, found, hit.t, allowed, out[0]);
            if (found) note_place(shape, ray, hit.t, out[0]);
            const auto naive = textbook_torus(shape, ray);
            note_answer(truth, ray, band, naive.has_value(), naive.value_or(0), allowed, out[1]);
          }
          out[0].digest = digest.value();
        },
        64);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

HardCase torus_case() {
  return {
      7,
      "a torus is hit or missed as its line says, touching it, along its axis and from far away",
      "Ferrari's formula cancels where two of the four roots are close or far from 0. Ours only separates "
      "crossings by the quartic and finds each as a sign change of the distance from the surface. Truth "
      "is the quartic in 113 digits.",
      3'000,
      100'000,
      run};
}

}  // namespace trace::hard
