#include "comparison/flip.hpp"

#include <algorithm>
#include <cmath>

#include "comparison/flip_color.hpp"
#include "comparison/flip_seen.hpp"
#include "comparison/parallel.hpp"

namespace trace {
namespace {

// Section 4.1.3 of the paper: the colours' distance to the power of 0.7, which is compressed so that up to
// 0.4 of the greatest (green against blue) are stretched to 0.95.
constexpr float color_power = 0.7F;
constexpr float compressed_from = 0.4F, compressed_to = 0.95F;
constexpr float least = 1e-30F;  // instead of 0, of which there is no logarithm

class ColorDifference {
 public:
  ColorDifference()
      : greatest_(fast_pow(hyab(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1})), color_power)) {}

  float operator()(const HuntLab& p, const HuntLab& q) const {
    const float distance = hyab(p, q);
    const float power = fast_pow(distance > least ? distance : least, color_power);
    const float limit = compressed_from * greatest_;
    const float below = power * (compressed_to / limit);
    const float above = compressed_to + (power - limit) * ((1 - compressed_to) / (greatest_ - limit));
    const float difference = power < limit ? below : above;
    return difference < 1 ? difference : 1.0F;
  }

 private:
  float greatest_;
};

// Section 4.3: the colours' difference raised by that of the features.
float pixel_flip(float color, float edge, float point) {
  const float strongest = edge > point ? edge : point;
  const float feature = std::sqrt(0.707106781F * strongest);
  const float limited = feature < 1 ? feature : 1.0F;
  return fast_pow(color > least ? color : least, 1 - limited);
}

double tile_sum(const FlipSeen& reference, const FlipSeen& test, const ColorDifference& color_difference) {
  double sum = 0;
  std::vector<float> flips(static_cast<std::size_t>(reference.l.width()));
  for (int y = 0; y < reference.l.height(); ++y) {
    const float *rl = reference.l.row(y), *ra = reference.a.row(y), *rb = reference.b.row(y);
    const float *tl = test.l.row(y), *ta = test.a.row(y), *tb = test.b.row(y);
    const float *re = reference.edges.row(y), *te = test.edges.row(y);
    const float *rp = reference.points.row(y), *tp = test.points.row(y);
    for (std::size_t x = 0; x < flips.size(); ++x) {
      const float color = color_difference({rl[x], ra[x], rb[x]}, {tl[x], ta[x], tb[x]});
      flips[x] = pixel_flip(color, std::abs(re[x] - te[x]), std::abs(rp[x] - tp[x]));
    }
    for (float value : flips) sum += static_cast<double>(value);
  }
  return sum;
}

}  // namespace

double flip(const Raster& reference, const Raster& test, const std::vector<float>& differences,
            unsigned threads) {
  const std::vector<Tile> tiles = tiles_that_differ(reference.width, reference.height, color_radius,
                                                    color_radius, differences, reference.width);
  const FlipFilters filters = flip_filters();
  const LinearOfLevel linear;
  const ColorDifference color_difference;
  std::vector<double> sums(tiles.size());
  in_parallel(tiles.size(), threads, [&](std::size_t i) {
    FlipObserver observer(filters, linear);
    FlipSeen seen_reference, seen_test;
    observer.look(reference, tiles[i], seen_reference);
    observer.look(test, tiles[i], seen_test);
    sums[i] = tile_sum(seen_reference, seen_test, color_difference);
  });
  double sum = 0;  // elsewhere it is 0
  for (double part : sums) sum += part;
  return sum / (static_cast<double>(reference.width) * reference.height);
}

}  // namespace trace
