#include "comparison/perceptual/flip.hpp"

#include <algorithm>
#include <cmath>

#include "comparison/perceptual/flip_color.hpp"
#include "comparison/perceptual/flip_seen.hpp"
#include "comparison/vector_clones.hpp"

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

// A row of a tile seen in one picture.
struct SeenRow {
  const float *l, *a, *b, *edges, *points;

  SeenRow(const FlipSeen& seen, int y)
      : l(seen.l.row(y)),
        a(seen.a.row(y)),
        b(seen.b.row(y)),
        edges(seen.edges.row(y)),
        points(seen.points.row(y)) {}
};

TRACE_VECTOR_CLONES void flip_row(const SeenRow r, const SeenRow t, const ColorDifference color_difference,
                                  float* __restrict flips, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const float color = color_difference({r.l[x], r.a[x], r.b[x]}, {t.l[x], t.a[x], t.b[x]});
    flips[x] = pixel_flip(color, std::abs(r.edges[x] - t.edges[x]), std::abs(r.points[x] - t.points[x]));
  }
}

double tile_sum(const FlipSeen& reference, const FlipSeen& test, const ColorDifference& color_difference) {
  double sum = 0;
  std::vector<float> flips(static_cast<std::size_t>(reference.l.width()));
  for (int y = 0; y < reference.l.height(); ++y) {
    flip_row(SeenRow(reference, y), SeenRow(test, y), color_difference, flips.data(), flips.size());
    for (float value : flips) sum += static_cast<double>(value);
  }
  return sum;
}

}  // namespace

Flip::Flip(const Raster& reference, const Raster& test, const std::vector<float>& differences)
    : reference_(reference),
      test_(test),
      tiles_(tiles_that_differ(reference.width, reference.height, color_radius, color_radius, differences,
                               reference.width)),
      sums_(tiles_.size()) {}

void Flip::measure_part(std::size_t part, Scratch& scratch) {
  scratch.observer.look(tools_, reference_, tiles_[part], scratch.reference);
  scratch.observer.look(tools_, test_, tiles_[part], scratch.test);
  sums_[part] = tile_sum(scratch.reference, scratch.test, ColorDifference());
}

double Flip::mean() const {
  double sum = 0;  // elsewhere it is 0
  for (double part : sums_) sum += part;
  return sum / (static_cast<double>(reference_.width) * reference_.height);
}

}  // namespace trace
