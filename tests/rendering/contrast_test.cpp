// Bins of contrast, and how many samples a contrast is worth.
#include "rendering/contrast.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace trace;

namespace {

bool on_grid_ladder(int n) {
  return std::find(grid_ladder.begin(), grid_ladder.end(), n) != grid_ladder.end();
}

}  // namespace

TEST_CASE("a bin begins with its least contrast and ends before that of the next") {
  CHECK(contrast_bin(0) == 0);
  for (int bin = 1; bin < contrast_bins; ++bin) {
    INFO(bin);
    const auto least = static_cast<float>(contrast_of_bin(bin));
    CHECK(contrast_bin(least) == bin);
    CHECK(contrast_bin(std::nextafter(least, 0.0f)) == bin - 1);
  }
}

TEST_CASE("bins rise with the contrast, by half as much again at most, and the last holds all that is more") {
  for (int bin = 2; bin < contrast_bins; ++bin) {
    CHECK(contrast_of_bin(bin) > contrast_of_bin(bin - 1));
    CHECK(contrast_of_bin(bin) <= 1.5 * contrast_of_bin(bin - 1));
  }
  int before = 0;
  for (float levels = 0; levels <= 255; levels += 0.01f) {
    const int bin = contrast_bin(levels);
    if (bin < before || contrast_of_bin(bin) > static_cast<double>(levels)) FAIL(levels);
    before = bin;
  }
  CHECK(contrast_bin(255) == contrast_bins - 1);
  CHECK(contrast_bin(1e6f) == contrast_bins - 1);
  CHECK(contrast_of_bin(contrast_bins - 1) > 128);
}

TEST_CASE("more contrast and a smaller threshold never take fewer samples") {
  GridByContrast finer{};
  finer.fill(16);
  for (double threshold = 0.01; threshold < 300; threshold *= 1.3) {
    INFO(threshold);
    const GridByContrast grids = grids_for_threshold(threshold, 16);
    CHECK(std::is_sorted(grids.begin(), grids.end()));
    CHECK(std::all_of(grids.begin(), grids.end(), on_grid_ladder));
    int more = 0;
    for (std::size_t bin = 0; bin < grids.size(); ++bin) more += grids[bin] > finer[bin];
    CHECK(more == 0);
    finer = grids;
  }
}

TEST_CASE("a pixel whose corners differ by no more than the threshold is left to their mean") {
  for (const double threshold : {0.5, 1.0, 4.0, 30.0}) {
    const GridByContrast grids = grids_for_threshold(threshold, 16);
    for (int bin = 0; bin < contrast_bins; ++bin) {
      if (contrast_of_bin(bin) <= threshold) CHECK(int{grids[static_cast<std::size_t>(bin)]} == 0);
    }
    CHECK(int{grids.back()} > 0);
  }
}

TEST_CASE("samples make the error of all contrasts alike where the ladder has them") {
  for (const double threshold : {2.0, 8.0, 20.0}) {
    const GridByContrast grids = grids_for_threshold(threshold, 16);
    int looked_at = 0;
    for (int bin = 1; bin < contrast_bins; ++bin) {
      const int n = grids[static_cast<std::size_t>(bin)];
      const double contrast = contrast_of_bin(bin) * 1.2;
      if (n == 0 || contrast > threshold * 64) continue;  // 16 x 16 is not beaten
      ++looked_at;
      const double error = contrast / std::pow(n, 1.5);
      INFO("bin " << bin << ", " << n << " x " << n);
      CHECK(error < 2 * threshold);
      CHECK(error > threshold / 2);
    }
    CHECK(looked_at > 3);
  }
}

TEST_CASE("no pixel gets more than the most that is asked for") {
  for (const int most : {2, 3, 5, 8}) {
    const GridByContrast grids = grids_for_threshold(0.01, most);
    const int expected = most == 5 ? 4 : most;  // the ladder has no 5
    CHECK(int{*std::max_element(grids.begin(), grids.end())} == expected);
  }
  const GridByContrast none = grids_for_threshold(0.01, 1);
  CHECK(std::all_of(none.begin(), none.end(), [](int n) { return n == 0; }));
}
