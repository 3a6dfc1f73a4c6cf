// NaN and infinity are counted and never pass for numbers.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "comparison/measure.hpp"
#include "rasters.hpp"

using namespace trace;
using namespace trace::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("a NaN pixel against a finite one is not identical") {
  const Measurements m = measure(floats(2, 1, 1, {0.5F, 0.5F}), floats(2, 1, 1, {0.5F, not_a_number}));
  CHECK_FALSE(m.identical());
  CHECK(m.not_finite.reference == 0);
  CHECK(m.not_finite.test == 1);
  CHECK(m.not_finite.first.x == 1);
  CHECK(m.not_finite.first.y == 0);
}

TEST_CASE("an infinite pixel is not finite on either side") {
  const Measurements m =
      measure(floats(1, 2, 3, {1, 1, 1, infinite, -infinite, 1}), floats(1, 2, 3, {1, 1, 1, 1, 1, 1}));
  CHECK(m.not_finite.reference == 2);
  CHECK(m.not_finite.test == 0);
  CHECK(m.not_finite.first.y == 1);
}

TEST_CASE("NaN at the same place in both pictures is not identical either") {
  const Raster picture = floats(1, 1, 3, {0, not_a_number, 0});
  const Measurements m = measure(picture, picture);
  CHECK_FALSE(m.identical());
  CHECK(m.not_finite.reference == 1);
  CHECK(m.not_finite.test == 1);
}

TEST_CASE("what is not finite is left out of every other figure") {
  // Besides the NaN, one pixel of two is off by half of full scale.
  const Raster reference = floats(3, 1, 1, {0, not_a_number, 0}), test = floats(3, 1, 1, {0.5F, 0, 0});
  const Measurements m = measure(reference, test);
  CHECK(m.error.root_mean_square == Approx(std::sqrt(127.5 * 127.5 / 2)));
  CHECK(m.error.mean_absolute == Approx(63.75));
  CHECK(m.percent_different == 50);
  CHECK(m.percentiles.p50 == 0);
  CHECK(m.percentiles.p90 == 127.5);
  CHECK(std::isfinite(m.edge_tolerant.root_mean_square));
}

TEST_CASE("SSIM and FLIP are absent where a sample of either picture is not finite") {
  const Raster good = floats(3, 1, 1, {0.5F, 0.5F, 0}), bad = floats(3, 1, 1, {0, not_a_number, 0});
  const Raster finite = floats(3, 1, 1, {0, 1, 0});
  CHECK(measure(good, finite).ssim);
  CHECK(measure(good, finite).flip);
  for (const Measurements& m : {measure(good, bad), measure(bad, good)}) {
    CHECK_FALSE(m.ssim);
    CHECK_FALSE(m.flip);
  }
}

TEST_CASE("samples that are not finite are found in a picture that says it holds bytes") {
  for (const float value : {not_a_number, infinite, -infinite}) {
    const Raster reference = uniform(20, 2, 3, 10);
    Raster test = uniform(20, 2, 3, 13);
    test.samples[70] = value;
    const Measurements m = measure(reference, test);
    CHECK(m.not_finite.test == 1);
    CHECK(m.not_finite.first.x == 3);
    CHECK(m.not_finite.first.y == 1);
    CHECK(m.error.largest == 3);
    CHECK(m.error.root_mean_square == Approx(3));
    CHECK(m.edge_tolerant.largest == 3);
    CHECK_FALSE(measure(test, test).identical());
  }
}

TEST_CASE("a picture of nothing but NaN has figures all the same") {
  const Raster picture = floats(2, 2, 1, std::vector<float>(4, not_a_number));
  const Measurements m = measure(picture, floats(2, 2, 1, {1, 1, 1, 1}));
  CHECK(m.not_finite.reference == 4);
  CHECK(m.error.root_mean_square == 0);
  CHECK(m.percent_different == 0);
  CHECK(m.edge_tolerant.largest == 0);
  CHECK(m.worst.empty());
}
