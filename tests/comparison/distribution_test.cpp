// Percentiles, foreground, the edge-tolerant score and the worst regions against truth found by hand.
#include <catch2/catch.hpp>
#include <cmath>

#include "comparison/measure.hpp"
#include "rasters.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("percentiles are by nearest rank") {
  // Differences 1 to 100 and 900 zeros: of 1000 values the 900th is 0, the 990th is 90, the 999th 99.
  Raster reference = uniform(100, 10, 1, 0), test = reference;
  for (int x = 0; x < 100; ++x) set(test, x, 4, 0, x + 1);
  const Measurements m = measure(reference, test);
  CHECK(m.percentiles.p50 == 0);
  CHECK(m.percentiles.p90 == 0);
  CHECK(m.percentiles.p99 == 90);
  CHECK(m.percentiles.p999 == 99);
}

TEST_CASE("percentiles of values that differ in their last bits only") {
  std::vector<float> zeros(10, 0.0F), values;
  for (int i = 0; i < 10; ++i) values.push_back(0.5F + static_cast<float>(9 - i) * 0x1p-20F);
  const Measurements m = measure(floats(10, 1, 1, zeros), floats(10, 1, 1, values));
  CHECK(m.percentiles.p50 == Approx(255 * (0.5 + 4 * 0x1p-20)).epsilon(1e-7));
  CHECK(m.percentiles.p90 == Approx(255 * (0.5 + 8 * 0x1p-20)).epsilon(1e-7));
  CHECK(m.percentiles.p999 == Approx(255 * (0.5 + 9 * 0x1p-20)).epsilon(1e-7));
}

TEST_CASE("the foreground is where either picture is not the colour of the reference's border") {
  Raster reference = uniform(10, 10, 3, 40), test = reference;
  set(reference, 4, 4, 0, 200);  // an object in the reference
  set(test, 4, 4, 0, 190);
  set(test, 5, 5, 1, 60);  // another that only the test has
  const Measurements m = measure(reference, test);
  CHECK(m.foreground.pixels == 2);
  CHECK(m.foreground.error.root_mean_square == Approx(std::sqrt(500.0 / 6)));
  CHECK(m.foreground.error.mean_signed == Approx(10.0 / 6));
  CHECK(m.foreground.error.largest == 20);
  CHECK(m.foreground.percent_over_one == 100);
  CHECK(m.percent_over_one == 2);
}

TEST_CASE("a larger background does not make an error smaller in the foreground") {
  const auto with_side = [](int side) {
    Raster reference = uniform(side, side, 1, 7), test = reference;
    for (int i = 1; i < 5; ++i) set(reference, i, 2, 0, 100), set(test, i, 2, 0, 110);
    return measure(reference, test);
  };
  CHECK(with_side(40).error.root_mean_square < with_side(10).error.root_mean_square);
  CHECK(with_side(40).foreground.error.root_mean_square == with_side(10).foreground.error.root_mean_square);
}

TEST_CASE("without a majority on the border the background is black") {
  Raster reference = uniform(3, 1, 1, 0);
  set(reference, 1, 0, 0, 10);
  set(reference, 2, 0, 0, 20);
  CHECK(measure(reference, reference).foreground.pixels == 2);
}

TEST_CASE("an edge shifted by a pixel is nothing to the edge-tolerant score") {
  const auto edge_at = [](int place) {
    return drawn(12, 12, [place](int x, int) { return std::array{x < place ? 0 : 250, 30, 30}; });
  };
  const Measurements m = measure(edge_at(5), edge_at(6));
  CHECK(m.error.largest == 250);
  CHECK(m.edge_tolerant.largest == 0);
  CHECK(measure(edge_at(5), edge_at(7)).edge_tolerant.largest == 250);
}

TEST_CASE("the edge-tolerant score sees a wrong surface, a thin line that is missing and one too many") {
  const Raster plain = uniform(9, 9, 3, 50), lighter = uniform(9, 9, 3, 60);
  CHECK(measure(plain, lighter).edge_tolerant.root_mean_square == 10);
  CHECK(measure(plain, lighter).edge_tolerant.percent_over_one == 100);
  Raster line = plain;
  for (int x = 0; x < 9; ++x) set(line, x, 4, 0, 200);
  CHECK(measure(plain, line).edge_tolerant.largest == 150);
  CHECK(measure(line, plain).edge_tolerant.largest == 150);
  // Only the line's own 9 of 81 pixels: what is beside it matches its neighbours.
  CHECK(measure(line, plain).edge_tolerant.percent_over_one == Approx(100.0 / 9));
}

TEST_CASE("the worst regions come by their squared error, with their box, pixels and RMSE") {
  Raster reference = uniform(64, 64, 1, 0), test = reference;
  for (int x = 2; x < 12; ++x) set(test, x, 2, 0, 10);   // 10 * 100
  set(test, 40, 8, 0, 100), set(test, 41, 9, 0, 100);    // 2 * 10000, touching corners
  for (int x = 30; x < 33; ++x) set(test, x, 40, 0, 3);  // 3 * 9
  set(test, 60, 60, 0, 2);                               // 4
  set(test, 20, 60, 0, 1);                               // no more than a level
  const Measurements m = measure(reference, test);
  REQUIRE(m.worst.size() == 3);
  CHECK(m.worst[0].x0 == 40);
  CHECK(m.worst[0].y0 == 8);
  CHECK(m.worst[0].x1 == 42);
  CHECK(m.worst[0].y1 == 10);
  CHECK(m.worst[0].pixels == 2);
  CHECK(m.worst[0].root_mean_square == Approx(std::sqrt(20000.0 / 4)));
  CHECK(m.worst[1].x0 == 2);
  CHECK(m.worst[1].x1 == 12);
  CHECK(m.worst[1].pixels == 10);
  CHECK(m.worst[1].root_mean_square == 10);
  CHECK(m.worst[2].pixels == 3);
}

TEST_CASE("a gap of 3 pixels never splits a region, one of 7 always does") {
  for (int shift = 0; shift < 4; ++shift) {
    Raster reference = uniform(40, 8, 1, 0), near = reference, far = reference;
    set(near, 5 + shift, 3, 0, 9), set(near, 9 + shift, 3, 0, 9);
    set(far, 5 + shift, 3, 0, 9), set(far, 13 + shift, 3, 0, 9);
    CHECK(measure(reference, near).worst.size() == 1);
    CHECK(measure(reference, far).worst.size() == 2);
  }
}
