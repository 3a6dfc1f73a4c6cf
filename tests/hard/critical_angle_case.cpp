// Row 12: refraction near the critical angle.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/hard/batches.hpp"
#include "tests/hard/light_cases.hpp"
#include "tests/hard/quad.hpp"
#include "tests/support/scene_trace.hpp"

namespace trace::hard {
namespace {

constexpr double wall_x = 5;
const Rgb transmission(0.9, 0.8, 0.7);

// A face in the plane z = 0, seen from either side, and a white wall that refracted rays meet.
Scene scene_of(double index) {
  Scene scene;
  test::add(scene, test::front_triangle(), test::scaled(4), test::transmissive(transmission, index));
  test::add(scene, Square{},
            glm::rotate(test::moved(wall_x, 0, 0), std::acos(0.0), Vec3(0, 1, 0)) * test::scaled(100),
            test::emissive(Rgb(1)));
  return scene;
}

// The sine of an angle of incidence: the critical one, and 1, 2, 4 ... ulps to 1e-3 beside it.
double sine_near(double critical, Random& random) {
  const double beside = std::ldexp(critical, -static_cast<int>(10 + random.below(43)));
  return std::min(1.0, critical + (random.below(2) == 0 ? beside : -beside));
}

// k = 1 - eta^2 sin^2, of the ray as it is; below 0 nothing is refracted. The luminance of the index rounds
// it thrice and the sine is rounded with the direction: some 8 * 2^-53 * eta^2 sin^2, which is about 1.
Quad k_of(const Ray& ray, double eta) {
  const QuadVec d(ray.direction);
  return 1 - Quad(eta) * eta * (d.x * d.x + d.y * d.y) / dot(d, d);
}
constexpr double undecided = 16 * 0x1p-53;

// `inside`: the ray leaves the medium through its face, which costs nothing; else it enters, and what the
// wall sends is attenuated by the way to it. That way, x / sin of the angle of refraction, is the length of
// the refracted direction.
void shoot(Random& random, bool inside, Row& row, Digest& digest) {
  const double index = inside ? random.between(1.05, 3) : random.between(0.3, 0.95);
  const double eta = inside ? index : 1 / index;
  const double sine = sine_near(1 / eta, random);
  const Vec3 direction(sine, 0, (inside ? 1 : -1) * std::sqrt(std::max(0.0, 1 - sine * sine)));
  const Ray ray{-direction + Vec3(random.between(-0.5, 0.5), 0, 0), glm::normalize(direction)};
  ShadingOptions options;
  options.backface_culling = false;
  const test::Traced traced = test::traced(scene_of(index), ray, 1, options);
  ++row.rays;
  const bool passes = traced.rays.refracted == 1;
  digest.add_hit(passes, traced.color.x);

  const Quad k = k_of(ray, eta);
  if (!is_finite(traced.color) || traced.rays.refracted > 1) {
    ++row.wrong;
  } else if (magnitude(k) > undecided && passes != (k > 0)) {
    ++row.wrong;
  } else if (!passes) {
    if (!is_zero(traced.color)) ++row.wrong;
  } else {
    const double met = ray.origin.x - ray.origin.z / ray.direction.z * ray.direction.x;
    const double sine_beyond = std::min(1.0, eta * ray.direction.x);
    const double way = inside ? 0 : (wall_x - met) / sine_beyond;
    for (int channel = 0; channel < 3; ++channel) {
      const double truth = std::pow(transmission[channel], way);
      // The way is some 5 long and a colour its exponential; direction and pow add a few roundings.
      if (!(std::abs(traced.color[channel] - truth) <= 1e-13)) {
        ++row.wrong;
        break;
      }
    }
  }
}

std::vector<Row> run(std::uint64_t rays) {
  std::vector<Row> all;
  for (const bool inside : {true, false}) {
    const auto rows = in_batches(rays / 2, inside ? 120 : 121,
                                 {Row(ours, inside ? "leaving" : "entering a thinner medium")},
                                 [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
                                   Digest digest;
                                   for (std::uint64_t i = 0; i < count; ++i)
                                     shoot(random, inside, out[0], digest);
                                   out[0].digest = digest.value();
                                 });
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

HardCase critical_angle_case() {
  return {12,
          "within ulps of the critical angle a ray is either refracted or totally reflected",
          "The sine of the refracted angle rounds to more than one where a root is about to be taken. The "
          "ray is refracted where 1 - eta^2 sin^2 is not negative, in a direction of unit length, and never "
          "both or neither.",
          4'000,
          400'000,
          run};
}

}  // namespace trace::hard
