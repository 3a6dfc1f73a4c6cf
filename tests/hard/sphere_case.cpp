// Row 6: spheres small in their distance.
#include "geometry/frame.hpp"
#include "geometry/sphere.hpp"
#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/curved_cases.hpp"
#include "tests/hard/nearby_rays.hpp"
#include "tests/hard/textbook_quadrics.hpp"
#include "tests/support/scene_make.hpp"

namespace trace::hard {
namespace {

// The unit sphere, from the squared distance of the line to its centre: nothing cancels that is not a
// coordinate of the ray itself.
TrueHit true_sphere(const QuadRay& ray, const QuadVec& centre, Quad radius) {
  const QuadVec from = ray.origin - centre;
  const Quad dd = dot(ray.direction, ray.direction);
  const Quad to_middle = -dot(from, ray.direction) / dd;
  const QuadVec across = from + to_middle * ray.direction;
  const Quad left = radius * radius - dot(across, across);
  if (left < 0) return std::nullopt;
  const Quad half_chord = root(left / dd);
  if (to_middle + half_chord <= 0) return std::nullopt;
  return to_middle > half_chord ? to_middle - half_chord : to_middle + half_chord;
}

// A distance of a line from the centre, in radii: anywhere up to 2, or grazing within a part in 2^2 ... 2^50.
double aim(Random& random) {
  if (random.below(2) == 0) return random.between(0, 2);
  const double part = random.between(-1, 1);
  return 1 + std::ldexp(part, -2 - static_cast<int>(random.below(49)));
}

// From `distance` away, past the centre at aim() radii.
Ray ray_at(Random& random, const Vec3& centre, double radius, double distance) {
  const Vec3 outward = unit_vector(random);
  const Vec3 side = glm::normalize(glm::cross(outward, unit_vector(random)));
  const Vec3 origin = centre + distance * outward;
  const Vec3 target = centre + aim(random) * radius * side;
  return {origin, glm::normalize(target - origin)};
}

// The foot of the perpendicular from the centre is rounded by 2^-53 of the distance in each coordinate, and
// the line is moved by as much; the rays around move it by at least a third of the band.
constexpr double band = 1e-15;

// The course's form is kept as long as it puts a hit within 2^-35 of the radius from the surface
// (geometry/quadratic.hpp), which is up to some 200 radii away: t is off by 2^-35 / 200 of itself at most.
constexpr double allowed = 1e-12;

std::vector<Row> far_spheres(std::uint64_t rays) {
  std::vector<Row> all;
  for (const double distance : {2.0, 1e2, 1e4, 1e5, 1e6, 1e7, 1e8}) {
    char workload[40];
    std::snprintf(workload, sizeof workload, "radius 1 at %g", distance);
    const auto rows = in_batches(
        rays / 7, static_cast<std::uint32_t>(distance), {Row(ours, workload), Row("textbook", workload)},
        [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
          const auto truth = [](const QuadRay& ray) { return true_sphere(ray, QuadVec(Vec3(0)), 1); };
          Digest digest;
          for (std::uint64_t i = 0; i < count; ++i) {
            const Ray ray = ray_at(random, Vec3(0), 1, distance);
            LocalHit hit;
            const bool found = Sphere{}.intersect(ray, hit);
            digest.add_hit(found, found ? hit.t : 0);
            note_answer(truth, ray, band, found, hit.t, allowed, out[0]);
            double t = 0;
            const bool naive = textbook_sphere(ray, t);
            note_answer(truth, ray, band, naive, t, allowed, out[1]);
          }
          out[0].digest = digest.value();
        });
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

// The language takes a ray into a space by its origin o and o + d, so the sum's rounding, half an ulp of |o|
// in each coordinate, turns the direction: 2^-53 * 128 * sqrt(3) for |o| up to 128, and the two
// products with the matrix as much again each.
constexpr double band_of_placed = 0x1p-53 * 128 * 8;

std::vector<Row> placed_spheres(std::uint64_t rays) {
  constexpr double radius = 1e-6;
  return in_batches(
      rays, 100, {Row(ours, "radius 1e-6 at 100"), Row("textbook", "radius 1e-6 at 100")},
      [](Random& random, std::uint64_t count, std::vector<Row>& out) {
        Digest digest;
        for (std::uint64_t i = 0; i < count; ++i) {
          const Vec3 centre = random.in_cube(1);
          const Frame frame(test::moved(centre.x, centre.y, centre.z) * test::scaled(radius));
          const auto truth = [&](const QuadRay& ray) { return true_sphere(ray, QuadVec(centre), radius); };
          const Ray ray = ray_at(random, centre, radius, 100);
          const ObjectRay object(frame, ray);
          LocalHit hit;
          const bool found = Sphere{}.intersect(object.ray, hit);
          const double t = found ? hit.t / object.scale : 0;
          digest.add_hit(found, t);
          note_answer(truth, ray, band_of_placed, found, t, allowed, out[0]);
          double naive_t = 0;
          const bool naive = textbook_sphere(object.ray, naive_t);
          note_answer(truth, ray, band_of_placed, naive, naive_t / object.scale, allowed, out[1]);
        }
        out[0].digest = digest.value();
      });
}

}  // namespace

HardCase far_sphere_case() {
  return {6,
          "a sphere is hit or missed as its line says, however far away",
          "From far away b^2 and 4ac agree in all digits that tell a hit from a miss. The discriminant is "
          "taken from the distance of the line to the centre, which keeps them.",
          14'000,
          2'000'000,
          far_spheres};
}

HardCase placed_sphere_case() {
  return {6,
          "a sphere of radius 1e-6 is hit or missed at a distance of 100",
          "In the space of such a sphere the ray starts 1e8 radii away. The band within which hit and miss "
          "cannot be told apart is that of the language's own way into the space, by o and o + d.",
          4'000,
          500'000,
          placed_spheres};
}

}  // namespace trace::hard
