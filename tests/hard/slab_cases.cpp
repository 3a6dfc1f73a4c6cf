#include "tests/hard/slab_cases.hpp"

#include "acceleration/bvh_build.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/textbook_slabs.hpp"

namespace trace::hard {
namespace {

// A closed box, maybe flat, and a ray through a point of it. All numbers are small multiples of one power of
// two, so that the ray holds the point exactly: no rounding excuses a miss.
struct ThroughBox {
  Bounds box;
  Ray ray;
};

ThroughBox through_box(Random& random) {
  const double unit = std::ldexp(1.0, static_cast<int>(random.below(81)) - 40);
  const double offset = random.below(4) == 0 ? std::ldexp(1.0, static_cast<int>(random.below(21))) : 0;
  const double steps = random.below(2) == 0 ? 0 : random.below(9);
  ThroughBox result;
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = offset + static_cast<int>(random.below(17)) - 8;
    const double size = random.below(2) == 0 ? 0 : 2.0 * (1 + random.below(8));
    result.box.min[axis] = unit * low;
    result.box.max[axis] = unit * (low + size);
    point[axis] = low + size * 0.5 * random.below(3);
  }
  Vec3 direction(0);
  while (direction == Vec3(0)) {
    const double choice[] = {0.0, -0.0, 1, -1, 0.0, -0.0, 0.25, -3};
    for (int axis = 0; axis < 3; ++axis) direction[axis] = choice[random.below(8)];
  }
  result.ray = {unit * (point - steps * direction), direction};
  return result;
}

bool handed_out(const ThroughBox& c) {
  bool found = false;
  const Bvh bvh = build_bvh({&c.box, 1}, 1);
  traverse(bvh, BvhRay(bvh, c.ray), std::numeric_limits<double>::infinity(),
           [&](std::uint32_t, std::uint32_t, double limit) {
             found = true;
             return limit;
           });
  return found;
}

void count(Row& row, bool found) {
  ++row.rays;
  if (!found) ++row.misses;
}

std::vector<Row> run(std::uint64_t rays) {
  return in_batches(rays, 4,
                    {Row(ours, "hierarchy of one box"), Row("min/max slabs"), Row("glm::min/max slabs")},
                    [](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
                      Digest digest;
                      for (std::uint64_t i = 0; i < in_batch; ++i) {
                        const ThroughBox c = through_box(random);
                        const bool found = handed_out(c);
                        digest.add_hit(i, found);
                        count(rows[0], found);
                        count(rows[1], std_slabs(c.box, c.ray));
                        count(rows[2], glm_slabs(c.box, c.ray));
                      }
                      rows[0].digest = digest.value();
                    });
}

}  // namespace

HardCase slab_case() {
  return {4,
          "a ray through a point of a closed box, flat or not, is handed what the box holds",
          "Scenes are full of upright boxes and squares, whose bounds have no thickness and whose planes "
          "hold rays, so "
          "that slabs meet 0 * inf. The hierarchy picks near and far planes by the sign of the direction, "
          "lets NaN lose "
          "every comparison and pads both ends by the bound of its own rounding.",
          20'000,
          10'000'000,
          run};
}

}  // namespace trace::hard
