// Samples to contrasts, on pilots made by hand.
#include "rendering/allocation.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace trace;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

// Errors that fall as n^-3 from that of the corners.
ContrastErrors falling(double pixels, double square) {
  ContrastErrors errors;
  errors.pixels = pixels;
  for (std::size_t step = 0; step < grid_ladder.size(); ++step) {
    const double n = std::max<int>(grid_ladder[step], 1);
    errors.square[step] = square / (n * n * n);
  }
  return errors;
}

SamplingPilot three_contrasts() {
  SamplingPilot pilot;
  pilot.bins[0] = falling(1000, 0);
  pilot.bins[5] = falling(300, 4);
  pilot.bins[15] = falling(100, 400);
  pilot.bins[24] = falling(50, 2000);
  return pilot;
}

std::size_t step_of(std::uint8_t n) {
  return static_cast<std::size_t>(std::find(grid_ladder.begin(), grid_ladder.end(), n) - grid_ladder.begin());
}

// What an allocation costs and leaves, counted anew.
Allocation counted(const SamplingPilot& pilot, const GridByContrast& grids) {
  Allocation result;
  double pixels = 0;
  for (std::size_t bin = 0; bin < pilot.bins.size(); ++bin) {
    const ContrastErrors& own = pilot.bins[bin];
    result.samples += own.pixels * grids[bin] * grids[bin];
    result.square_error += own.pixels * own.square[step_of(grids[bin])];
    pixels += own.pixels;
  }
  result.square_error /= pixels;
  return result;
}

}  // namespace

TEST_CASE("without pixels nothing is allocated") {
  const Allocation none = allocate(SamplingPilot{}, 0, no_limit);
  CHECK(none.grids == GridByContrast{});
  CHECK(none.samples == 0);
  CHECK(none.square_error == 0);
}

TEST_CASE("an allocation reaches the error that is asked for, if the ladder does") {
  const SamplingPilot pilot = three_contrasts();
  for (const double asked : {100.0, 30.0, 10.0, 1.0, 0.1}) {
    const Allocation result = allocate(pilot, asked, no_limit);
    INFO(asked);
    CHECK(result.square_error <= asked);
    CHECK(result.square_error == Approx(counted(pilot, result.grids).square_error));
    CHECK(result.samples == counted(pilot, result.grids).samples);
  }
  const Allocation all = allocate(pilot, 0, no_limit);
  CHECK(all.square_error > 0);
  for (const std::size_t bin : {5u, 15u, 24u}) CHECK(int{all.grids[bin]} == 16);
}

TEST_CASE("nothing is spent where the corners are good enough already") {
  const SamplingPilot pilot = three_contrasts();
  const Allocation result = allocate(pilot, counted(pilot, {}).square_error, no_limit);
  CHECK(result.grids == GridByContrast{});
  CHECK(result.samples == 0);
}

TEST_CASE("a smaller error never costs less") {
  const SamplingPilot pilot = three_contrasts();
  double samples = 0;
  for (double asked = 200; asked > 0.05; asked /= 1.2) {
    const Allocation result = allocate(pilot, asked, no_limit);
    CHECK(result.samples >= samples);
    samples = result.samples;
  }
}

TEST_CASE("an allocation keeps its limit of samples and makes use of it") {
  const SamplingPilot pilot = three_contrasts();
  CHECK(allocate(pilot, 0, 0).grids == GridByContrast{});
  CHECK(allocate(pilot, 0, 199).samples == 0);  // the least step is 50 pixels of 2 x 2
  CHECK(allocate(pilot, 0, 200).samples == 200);
  for (double limit = 200; limit < 200000; limit *= 1.3) {
    const Allocation result = allocate(pilot, 0, limit);
    CHECK(result.samples <= limit);
    if (limit < 100000) CHECK(result.samples > limit / 4);
    CHECK(result.samples == counted(pilot, result.grids).samples);
  }
}

TEST_CASE("samples go where they lower the error most for what they cost") {
  SamplingPilot pilot;
  pilot.bins[3] = falling(1000, 1);
  pilot.bins[9] = falling(1000, 100);
  const Allocation result = allocate(pilot, 0, 4000);
  CHECK(int{result.grids[3]} == 0);
  CHECK(int{result.grids[9]} == 2);
  // Contrast itself counts for nothing, nor how many pixels have it.
  pilot.bins[9] = falling(5, 100);
  CHECK(int{allocate(pilot, 0, 4019).grids[3]} == 0);  // its gain is 875, that of the other 500 at most
  CHECK(int{allocate(pilot, 0, 4019).grids[9]} > 2);
}

TEST_CASE("a bin without pixels or without error gets no samples, whatever is asked for") {
  SamplingPilot pilot = three_contrasts();
  pilot.bins[20].square.fill(1e6);  // of no pixels
  const Allocation result = allocate(pilot, 0, no_limit);
  for (std::size_t bin = 0; bin < contrast_bins; ++bin) {
    const bool worth_it = bin == 5 || bin == 15 || bin == 24;
    CHECK((result.grids[bin] > 0) == worth_it);
  }
}

TEST_CASE("a step that gains nothing is no end where a later one gains") {
  SamplingPilot pilot;
  pilot.bins[7].pixels = 10;
  pilot.bins[7].square = {9, 9, 9, 1, 1, 1, 1, 1};
  const Allocation result = allocate(pilot, 2, no_limit);
  CHECK(result.grids[7] == grid_ladder[3]);
  CHECK(result.square_error == Approx(1));
  CHECK(allocate(pilot, 0.5, no_limit).grids[7] == grid_ladder[3]);  // more would cost and gain nothing
}
