#include "comparison/perceptual/flip_seen.hpp"

#include <algorithm>
#include <cmath>

#include "comparison/perceptual/flip_color.hpp"
#include "comparison/perceptual/shown_color.hpp"
#include "comparison/vector_clones.hpp"

namespace trace {
namespace {

TRACE_VECTOR_CLONES void magnitude_row(float* __restrict a, const float* __restrict b, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) a[x] = std::sqrt(a[x] * a[x] + b[x] * b[x]);
}

// sqrt(a^2 + b^2) of two planes, into the first.
void magnitude(Plane& a, const Plane& b) {
  for (int y = 0; y < a.height(); ++y) magnitude_row(a.row(y), b.row(y), static_cast<std::size_t>(a.width()));
}

// Filtered opponent colours, the last of which comes in two parts, into L, a and b.
TRACE_VECTOR_CLONES void lab_row(float* __restrict l, float* __restrict a, float* __restrict b,
                                 const float* __restrict second, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const HuntLab lab = to_hunt_lab(to_linear_rgb({l[x], a[x], b[x] + second[x]}));
    l[x] = lab.l;
    a[x] = lab.a;
    b[x] = lab.b;
  }
}

// Linear light into opponent colours.
TRACE_VECTOR_CLONES void opponent_row(float* __restrict r, float* __restrict g, float* __restrict b,
                                      std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const Opponent color = to_opponent({r[x], g[x], b[x]});
    r[x] = color.y;
    g[x] = color.red_green;
    b[x] = color.blue_yellow;
  }
}

// The next `count` pixels as linear light.
void load_linear(const LinearOfLevel& linear_level, const Raster& raster, const float* pixel, int count,
                 float* red, float* green, float* blue) {
  const auto convert = [&](const auto& linear) {
    for (int x = 0; x < count; ++x, pixel += raster.channels) {
      const auto [r, g, b] = shown_color(pixel, raster.channels);
      red[x] = linear(r);
      green[x] = linear(g);
      blue[x] = linear(b);
    }
  };
  if (raster.type != SampleType::uint8) return convert(linear_of_srgb);
  if (raster.channels != 3) return convert(linear_level);
  for (int x = 0; x < count; ++x, pixel += 3) {  // the usual: nothing to clamp or to spread
    red[x] = linear_level(pixel[0]);
    green[x] = linear_level(pixel[1]);
    blue[x] = linear_level(pixel[2]);
  }
}

}  // namespace

void FlipObserver::load(const LinearOfLevel& linear, const Raster& raster, const Tile& surroundings) {
  for (Plane* plane : {&light_, &red_green_, &blue_yellow_})
    plane->resize(surroundings.width(), surroundings.height());
  const int width = light_.width();
  // [from, to) lies in the picture; what lies left and right of that is filled with its ends.
  const int from = std::max(0, -surroundings.x0), to = std::min(width, raster.width - surroundings.x0);
  for (int y = 0; y < light_.height(); ++y) {
    const int picture_y = std::clamp(surroundings.y0 + y, 0, raster.height - 1);
    const float* pixel = raster.pixel(surroundings.x0 + from, picture_y);
    float *red = light_.row(y), *green = red_green_.row(y), *blue = blue_yellow_.row(y);
    load_linear(linear, raster, pixel, to - from, red + from, green + from, blue + from);
    for (float* row : {red, green, blue}) {
      std::fill(row, row + from, row[from]);
      std::fill(row + to, row + width, row[to - 1]);
    }
    opponent_row(red, green, blue, static_cast<std::size_t>(width));
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

void FlipObserver::see_colors(const FlipFilters& filters, FlipSeen& seen) {
  filter(light_, filters.light, seen.l);
  filter(red_green_, filters.red_green, seen.a);
  filter(blue_yellow_, filters.blue_yellow_1, seen.b);
  filter(blue_yellow_, filters.blue_yellow_2, second_);
  for (int y = 0; y < seen.l.height(); ++y)
    lab_row(seen.l.row(y), seen.a.row(y), seen.b.row(y), second_.row(y),
            static_cast<std::size_t>(seen.l.width()));
}

void FlipObserver::see_features(const FlipFilters& filters, FlipSeen& seen) {
  cut(light_, color_radius - feature_radius, cut_);
  filter_rows(cut_, filters.smooth, smooth_);
  filter_rows(cut_, filters.edge, edge_);
  filter_rows(cut_, filters.point, point_);
  filter_columns(edge_, filters.smooth, seen.edges);
  filter_columns(smooth_, filters.edge, second_);
  magnitude(seen.edges, second_);
  filter_columns(point_, filters.smooth, seen.points);
  filter_columns(smooth_, filters.point, second_);
  magnitude(seen.points, second_);
}

void FlipObserver::look(const FlipTools& tools, const Raster& raster, const Tile& tile, FlipSeen& seen) {
  load(tools.linear, raster,
       {tile.x0 - color_radius, tile.y0 - color_radius, tile.x1 + color_radius, tile.y1 + color_radius});
  see_colors(tools.filters, seen);
  see_features(tools.filters, seen);
}

}  // namespace trace
