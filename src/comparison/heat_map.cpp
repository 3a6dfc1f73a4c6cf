#include "comparison/heat_map.hpp"

#include <fmt/format.h>

#include <string>

#include "comparison/bitmap_digits.hpp"
#include "comparison/pixel_differences.hpp"
#include "comparison/viridis.hpp"

namespace trace {
namespace {

constexpr MapColor not_finite_color{255, 0, 255};
constexpr MapColor white{255, 255, 255};

// The legend's rows: the bar, a gap, and the labels twice as large as bitmap_digits.hpp has them.
constexpr int bar_height = 8, label_top = 10, label_scale = 2;
static_assert(label_top + label_scale * digit_height <= legend_height);

class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  void put(int x, int y, const MapColor& color) {
    const std::size_t at =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
    for (std::size_t c = 0; c < 3; ++c) image_.rgb[3 * at + c] = color[c];
  }

  void write(int left, int top, const std::string& text) {
    for (const char character : text) {
      const auto rows = digit_rows(character);
      for (int y = 0; y < label_scale * digit_height; ++y)
        for (int x = 0; x < label_scale * digit_width; ++x) {
          const auto row = rows[static_cast<std::size_t>(y / label_scale)];
          if (row >> (digit_width - 1 - x / label_scale) & 1) put(left + x, top + y, white);
        }
      left += label_scale * (digit_width + 1);
    }
  }

 private:
  Image& image_;
};

int text_width(const std::string& text) {
  return label_scale * (static_cast<int>(text.size()) * (digit_width + 1) - 1);
}

void draw_legend(Canvas& canvas, int width, int top, double full_scale) {
  for (int y = 0; y < bar_height; ++y)
    for (int x = 0; x < width; ++x) canvas.put(x, top + 1 + y, viridis(static_cast<double>(x) / (width - 1)));
  if (width < least_label_width) return;
  // In levels, rounded to three digits; never in the form 1e+02.
  const auto label = [](double levels) {
    return levels >= 100 ? fmt::format("{:.0f}", levels) : fmt::format("{:.3g}", levels);
  };
  const std::string middle = label(full_scale / 2), end = label(full_scale);
  canvas.write(0, top + label_top, "0");
  canvas.write((width - text_width(middle)) / 2, top + label_top, middle);
  canvas.write(width - text_width(end), top + label_top, end);
}

}  // namespace

Image heat_map(const Raster& reference, const Raster& test, double amplify) {
  const PixelDifferences differences = pixel_differences(reference, test);
  const double full_scale = 255 / amplify;
  const bool legend = reference.width >= least_legend_width;
  Image map{reference.width, reference.height + (legend ? legend_height : 0), {}};
  map.rgb.resize(std::size_t{3} * static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  Canvas canvas(map);
  std::size_t i = 0;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x, ++i) {
      const float levels = differences.levels[i];
      canvas.put(x, y,
                 levels == left_out ? not_finite_color : viridis(static_cast<double>(levels) / full_scale));
    }
  if (legend) draw_legend(canvas, map.width, reference.height, full_scale);
  return map;
}

}  // namespace trace
