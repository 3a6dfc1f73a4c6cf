#include "comparison/flip_seen.hpp"

#include <algorithm>
#include <cmath>

#include "comparison/flip_color.hpp"
#include "comparison/shown_color.hpp"

namespace trace {
namespace {

// sqrt(a^2 + b^2) of two planes, into the first.
void magnitude(Plane& a, const Plane& b) {
  for (int y = 0; y < a.height(); ++y) {
    float* p = a.row(y);
    const float* q = b.row(y);
    for (int x = 0; x < a.width(); ++x) p[x] = std::sqrt(p[x] * p[x] + q[x] * q[x]);
  }
}

}  // namespace

void FlipObserver::load(const Raster& raster, const Tile& surroundings) {
  for (Plane* plane : {&light_, &red_green_, &blue_yellow_})
    plane->resize(surroundings.width(), surroundings.height());
  const bool levels = raster.type == SampleType::uint8;
  for (int y = 0; y < light_.height(); ++y) {
    const int from_y = std::clamp(surroundings.y0 + y, 0, raster.height - 1);
    float *light = light_.row(y), *red_green = red_green_.row(y), *blue_yellow = blue_yellow_.row(y);
    for (int x = 0; x < light_.width(); ++x) {
      const int from_x = std::clamp(surroundings.x0 + x, 0, raster.width - 1);
      const auto [r, g, b] = shown_color(raster.pixel(from_x, from_y), raster.channels);
      const Opponent color =
          to_opponent(levels ? LinearRgb{linear_(r), linear_(g), linear_(b)}
                             : LinearRgb{linear_of_srgb(r), linear_of_srgb(g), linear_of_srgb(b)});
      light[x] = color.y;
      red_green[x] = color.red_green;
      blue_yellow[x] = color.blue_yellow;
    }
  }
}

void FlipObserver::filter(const Plane& in, const FlipFilters::Taps& taps, Plane& out) {
  const int spare = color_radius - static_cast<int>(taps.size() / 2);
  const Plane* from = &in;
  if (spare > 0) {
    cut(in, spare, cut_);
    from = &cut_;
  }
  filter_rows(*from, taps, scratch_);
  filter_columns(scratch_, taps, out);
}

void FlipObserver::see_colors(FlipSeen& seen) {
  filter(light_, filters_.light, seen.l);
  filter(red_green_, filters_.red_green, seen.a);
  filter(blue_yellow_, filters_.blue_yellow_1, seen.b);
  filter(blue_yellow_, filters_.blue_yellow_2, second_);
  for (int y = 0; y < seen.l.height(); ++y) {
    float *l = seen.l.row(y), *a = seen.a.row(y), *b = seen.b.row(y);
    const float* second = second_.row(y);
    for (int x = 0; x < seen.l.width(); ++x) {
      const HuntLab lab = to_hunt_lab(to_linear_rgb({l[x], a[x], b[x] + second[x]}));
      l[x] = lab.l;
      a[x] = lab.a;
      b[x] = lab.b;
    }
  }
}

void FlipObserver::see_features(FlipSeen& seen) {
  cut(light_, color_radius - feature_radius, cut_);
  filter_rows(cut_, filters_.smooth, smooth_);
  filter_rows(cut_, filters_.edge, edge_);
  filter_rows(cut_, filters_.point, point_);
  filter_columns(edge_, filters_.smooth, seen.edges);
  filter_columns(smooth_, filters_.edge, second_);
  magnitude(seen.edges, second_);
  filter_columns(point_, filters_.smooth, seen.points);
  filter_columns(smooth_, filters_.point, second_);
  magnitude(seen.points, second_);
}

void FlipObserver::look(const Raster& raster, const Tile& tile, FlipSeen& seen) {
  load(raster,
       {tile.x0 - color_radius, tile.y0 - color_radius, tile.x1 + color_radius, tile.y1 + color_radius});
  see_colors(seen);
  see_features(seen);
}

}  // namespace trace
