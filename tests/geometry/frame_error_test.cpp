// The bounds that a frame gives, against 113 bits.
#include <catch2/catch.hpp>

#include "geometry/frame.hpp"
#include "tests/support/random_places.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// The largest difference in a coordinate.
double off(const Vec3& computed, const std::array<Quad, 3>& truth) {
  Quad most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Quad d = magnitude(truth[i] - computed[static_cast<int>(i)]);
    if (d > most) most = d;
  }
  return static_cast<double>(most);
}

Vec3 carried(const Frame& frame, const Vec3& p) {
  return Vec3(frame.to_object * Vec4(p, 1));
}

}  // namespace

TEST_CASE("a world point carried into an object is within error() of the truth, and within rounding()") {
  RandomPlaces random(4);
  int points = 0, wrong = 0, wrong_rounding = 0, wrong_difference = 0;
  std::vector<double> ratios;
  for (int i = 0; i < 10'000; ++i) {
    const RandomPlace place = random.place(20, i % 2 == 0 ? 1 : 9);
    if (!place.placement.reliable()) continue;
    const Frame frame(place.placement);
    REQUIRE(frame.invertible());
    const QuadMatrix stored(frame.to_object);
    double worst = 0, bound = 0;
    for (int j = 0; j < 20; ++j) {
      // Points about the object, and points anywhere.
      const Vec3 local{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      const Vec3 p = j % 2 == 0 ? Vec3(frame.to_world * Vec4(local, 1)) : random.vector_of_size(-9, 9);
      const Vec3 there = carried(frame, p);
      const double size = largest(p);
      ++points;
      const double d = off(there, place.exact.inverse.times(p, 1));
      if (!(d <= frame.error(size))) ++wrong;
      if (!(off(there, stored.times(p, 1)) <= frame.rounding(size))) ++wrong_rounding;
      const Vec3 direction = glm::normalize(random.vector_of_size(-3, 0));
      const Vec3 difference = carried(frame, p + direction) - there;
      // The difference is itself rounded.
      const double last = 0x1p-53 * largest(difference);
      if (!(off(difference, stored.times(direction, 0)) <= frame.difference_error(size) + last))
        ++wrong_difference;
      if (j % 2 == 0 && d > worst) worst = d, bound = frame.error(size);
    }
    if (worst > 0) ratios.push_back(bound / worst);
  }
  CHECK(points > 190'000);
  CHECK(wrong == 0);
  CHECK(wrong_rounding == 0);
  CHECK(wrong_difference == 0);
  // The bound is of use: within a factor of 1000 of the worst of ten points for half of the frames.
  std::sort(ratios.begin(), ratios.end());
  INFO("bound / worst of 10 points: 5 % " << ratios[ratios.size() / 20] << ", median "
                                          << ratios[ratios.size() / 2] << ", 95 % "
                                          << ratios[ratios.size() * 19 / 20]);
  CHECK(ratios[ratios.size() / 2] < 1000);
}

TEST_CASE("nothing is lost in the world's own space") {
  const Frame frame{Placement()};
  CHECK(frame.error(1e9) == 0);
  CHECK(frame.rounding(1e9) == 0);
  CHECK(frame.to_object_stretch == Approx(1));
  CHECK(Frame(Mat4(1)).error(1) == 0);
}

TEST_CASE("moving an object rounds once, turning and scaling it three times") {
  const double u = 0x1p-53;
  CHECK(Frame(Placement().inside(translation({1, 2, 3}))).error(1) == Approx(4 * u));
  CHECK(Frame(Placement().inside(scaling(Vec3(4)))).error(1) == 0);
  CHECK(Frame(Placement().inside(scaling(Vec3(3)))).rounding(1) == Approx(u / 3));
  const Frame turned(Placement().inside(rotation({0, 0, 1}, 0.5)));
  CHECK(turned.rounding(1) == Approx(2 * u * (std::cos(0.5) + std::sin(0.5))));
}

TEST_CASE("a displacement grows by no more than the stretch between the spaces") {
  RandomPlaces random(5);
  int wrong = 0;
  for (int i = 0; i < 2'000; ++i) {
    const Frame frame(random.place(10, 2).placement);
    const double e = random.between(0, 1);
    const Vec3 d{e, random.between(0, 1) < 0.5 ? e : -e, random.between(0, 1) < 0.5 ? e : -e};
    const auto largest_of = [](const std::array<Quad, 3>& v) {
      return std::max({magnitude(v[0]), magnitude(v[1]), magnitude(v[2])});
    };
    if (!(largest_of(QuadMatrix(frame.to_object).times(d, 0)) <= Quad(frame.to_object_stretch) * e)) ++wrong;
    if (!(largest_of(QuadMatrix(frame.to_world).times(d, 0)) <= Quad(frame.to_world_stretch) * e)) ++wrong;
  }
  CHECK(wrong == 0);
}
