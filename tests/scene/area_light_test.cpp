#include <catch2/catch.hpp>

#include "scene/light.hpp"
#include "scene/sample_pattern.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

std::vector<Vec3> places_of(const AreaLight& light, int n) {
  std::vector<Vec3> result;
  for (const PlainLight& one : light.samples(n)) result.push_back(std::get<PointLight>(one).position);
  return result;
}

}  // namespace

TEST_CASE("the samples of a square fill its strata, and no two are in the same column or row") {
  const int n = GENERATE(1, 2, 3, 4, 7);
  std::vector<int> column(static_cast<std::size_t>(n * n)), row = column, cell = column;
  for (int k = 0; k < n * n; ++k) {
    const Vec2 s = multi_jittered(n, k);
    ++column[static_cast<std::size_t>(s.x * n * n)];
    ++row[static_cast<std::size_t>(s.y * n * n)];
    ++cell[static_cast<std::size_t>(s.x * n) +
           static_cast<std::size_t>(n) * static_cast<std::size_t>(s.y * n)];
  }
  const std::vector<int> once(static_cast<std::size_t>(n * n), 1);
  CHECK(column == once);
  CHECK(row == once);
  CHECK(cell == once);
}

TEST_CASE("all samples of a light share its colour") {
  AreaLight light{};
  light.color = Rgb(9, 18, 27);
  light.u = Vec3(1, 0, 0);
  light.v = Vec3(0, 2, 0);
  const std::vector<PlainLight> samples = light.samples(3);
  REQUIRE(samples.size() == 9);
  for (const PlainLight& one : samples) CHECK(std::get<PointLight>(one).color == Rgb(1, 2, 3));
}

TEST_CASE("one sample of a light with a size is its middle") {
  AreaLight light{};
  light.u = Vec3(1, 0, 0);
  light.v = Vec3(0, 2, 0);
  CHECK(places_of(light, 1) == std::vector<Vec3>{{0.5, 1, 0}});
  light.extent = AreaLight::Extent::disc;
  CHECK(places_of(light, 1) == std::vector<Vec3>{{0, 0, 0}});
}

TEST_CASE("the samples of a disc and of a ball are as many in each ring of equal area as its area says") {
  AreaLight light{};
  light.extent = GENERATE(AreaLight::Extent::disc, AreaLight::Extent::ball);
  light.u = Vec3(2, 0, 0);
  light.v = Vec3(0, 2, 0);
  // Seen along z, and a ball from another side too.
  for (const int from : {2, 0}) {
    if (from == 0 && light.extent == AreaLight::Extent::disc) continue;
    std::array<double, 4> rings{};
    for (Vec3 place : places_of(light, 32)) {
      place[from] = 0;
      const double area = glm::dot(place, place) / 4;
      REQUIRE(area < 1 + 1e-12);
      rings[std::min<std::size_t>(3, static_cast<std::size_t>(4 * area))] += 1.0 / 1024;
    }
    for (const double part : rings) CHECK(part == Approx(0.25).margin(0.04));
  }
}

TEST_CASE("the radii of an even disc are those of its distribution") {
  for (const double r : {0.1, 0.5, 0.9}) {
    const double a = std::asin(r);
    CHECK(radius_of_even_disc(2 / 3.14159265358979323846 * (a - r * std::cos(a))) == about(r));
  }
}
