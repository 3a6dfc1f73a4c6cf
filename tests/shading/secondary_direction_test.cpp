// Truth is long double: 64 bits of mantissa, so its own error is 2^-11 of what is tested.
#include "shading/secondary_direction.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "geometry/rounding.hpp"

using namespace trace;

namespace {

using Real = long double;

// 1 - eta^2 |d - (n.d) n|^2 of the very numbers given.
Real true_k(const Vec3& d, const Vec3& n, double eta) {
  const Real cosine = Real(n.x) * d.x + Real(n.y) * d.y + Real(n.z) * d.z;
  Real square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Real w = Real(d[axis]) - cosine * n[axis];
    square += w * w;
  }
  return 1 - Real(eta) * eta * square;
}

Real true_length(const Vec3& v) {
  return std::sqrt(Real(v.x) * v.x + Real(v.y) * v.y + Real(v.z) * v.z);
}

// d with the sine `s` of its angle to -n, in a random position in space.
struct Incidence {
  Vec3 d, n;
};
template <class Engine>
Incidence incidence(Real s, Engine& engine) {
  std::normal_distribution<double> normal;
  const auto random = [&] { return Vec3(normal(engine), normal(engine), normal(engine)); };
  glm::vec<3, Real> n(random()), across(random());
  n /= std::sqrt(glm::dot(n, n));
  across -= glm::dot(across, n) * n;
  across /= std::sqrt(glm::dot(across, across));
  return {Vec3(s * across - std::sqrt(1 - s * s) * n), Vec3(n)};
}

// Sines around that of the critical angle: 1 to 1000 ulps and 1e-15 to 1e-3 to both sides, and itself.
std::vector<Real> sines_near_critical(double eta) {
  const double critical = 1 / eta, ulp = std::nextafter(critical, 2.0) - critical;
  std::vector<Real> sines{critical};
  for (const int ulps : {1, 2, 3, 4, 8, 16, 100, 1000}) {
    for (const int side : {-1, 1}) sines.push_back(Real(critical) + side * ulps * Real(ulp));
  }
  for (int power = 3; power <= 15; ++power) {
    const Real angle = std::pow(Real(10), -power);
    for (const int side : {-1, 1}) sines.push_back(std::sin(std::asin(1 / Real(eta)) + side * angle));
  }
  return sines;
}

}  // namespace

TEST_CASE("near the critical angle light is refracted or totally reflected as the true sine says") {
  std::mt19937_64 engine(1);
  const double eta = GENERATE(1.0001, 1.3, 1.5, 2.4, 10.0);
  const double bound = (2 * eta + 10) * unit_roundoff;
  int refracted = 0, total = 0, within_bound = 0;
  for (const Real s : sines_near_critical(eta)) {
    for (int turn = 0; turn < 500; ++turn) {
      const Incidence ray = incidence(s, engine);
      const auto bent = refracted_direction(ray.d, ray.n, eta);
      const Real k = true_k(ray.d, ray.n, eta);
      if (std::abs(k) <= bound) {
        ++within_bound;
      } else {
        CAPTURE(eta, static_cast<double>(s - 1 / Real(eta)), static_cast<double>(k));
        REQUIRE(bent.has_value() == (k > 0));
      }
      bent ? ++refracted : ++total;
    }
  }
  CHECK(refracted > 1000);
  CHECK(total > 1000);
  CHECK(within_bound > 0);  // else the sweep was not near enough
}

TEST_CASE(
    "a direction refracted near the critical angle is of unit length within 4 ulps and keeps its sine") {
  std::mt19937_64 engine(2);
  const double eta = GENERATE(1.0001, 1.3, 1.5, 2.4);
  for (const Real s : sines_near_critical(eta)) {
    for (int turn = 0; turn < 500; ++turn) {
      const Incidence ray = incidence(s, engine);
      const auto bent = refracted_direction(ray.d, ray.n, eta);
      if (!bent) continue;
      REQUIRE(is_finite(*bent));
      REQUIRE(std::abs(true_length(*bent) - 1) <= 8 * unit_roundoff);
      // Snell: across the normal it is eta times what it was.
      const Real before = std::sqrt(std::max(Real(0), 1 - true_k(ray.d, ray.n, eta)));
      const Real after = std::sqrt(std::max(Real(0), 1 - true_k(*bent, ray.n, 1)));
      REQUIRE(std::abs(after - before) <= (2 * eta + 10) * unit_roundoff);
    }
  }
}

TEST_CASE("light that falls straight on a surface goes straight on, whatever the index") {
  const Vec3 n(0.6, 0, 0.8);
  const double eta = GENERATE(0.0, 1e-300, 0.5, 1.5, 1e15);
  const auto bent = refracted_direction(-n, n, eta);
  REQUIRE(bent);
  CHECK(glm::length(*bent + n) <= 1e-15 * (1 + eta));
}

TEST_CASE("an index of 0 refracts nothing from outside and everything along the normal from inside") {
  const Vec3 n(0, 0, 1);
  for (const Vec3& d : {Vec3(0, 0, -1), Vec3(0.6, 0, -0.8), Vec3(1, 0, 0)}) {
    CHECK_FALSE(refracted_direction(d, n, 1 / 0.0));
    CHECK(refracted_direction(d, n, 0) == Vec3(0, 0, -1));
  }
}

TEST_CASE(
    "the mirrored direction has the length of the direction and the angle to the normal, grazing ones too") {
  std::mt19937_64 engine(3);
  for (const Real s : {Real(0), Real(0.3), Real(0.999), 1 - Real(1e-12), 1 - Real(1e-16), Real(1)}) {
    for (int turn = 0; turn < 500; ++turn) {
      const Incidence ray = incidence(s, engine);
      const Vec3 out = mirrored_direction(ray.d, ray.n);
      REQUIRE(std::abs(true_length(out) - 1) <= 16 * unit_roundoff);
      const Vec3 sum = out + ray.d;  // lies across the normal
      REQUIRE(std::abs(glm::dot(sum, ray.n)) <= 20 * unit_roundoff);
    }
  }
}
