#include "comparison/reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "comparison/pixel_differences.hpp"

namespace trace {
namespace {

std::string shown(double value, double limit) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return fmt::format("{:.0f}", value);
  std::string text;
  const int two_digits = 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  for (int decimals = std::clamp(two_digits, 2, 17); decimals <= 17; ++decimals) {
    text = fmt::format("{:.{}f}", value, decimals);
    const double rounded = std::strtod(text.c_str(), nullptr);
    if ((value > limit) == (rounded > limit) && (value < limit) == (rounded < limit)) break;
  }
  return text;
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

class Excesses {
 public:
  void at_most(std::string_view name, double value, const std::optional<double>& limit) {
    if (limit && !(value <= *limit)) add(fmt::format("{} {} is over {}", name, shown(value, *limit), *limit));
  }
  void at_least(std::string_view name, double value, const std::optional<double>& limit) {
    if (limit && !(value >= *limit))
      add(fmt::format("{} {} is under {}", name, shown(value, *limit), *limit));
  }
  void pixels(double percent, double levels, const std::optional<double>& limit) {
    if (!limit || percent <= *limit) return;
    add(fmt::format("{} % of the pixels are off by more than {} level{}, which is over {} %",
                    shown(percent, *limit), levels, levels == 1 ? "" : "s", *limit));
  }
  const std::string& text() const { return text_; }

 private:
  void add(const std::string& excess) { text_ += (text_.empty() ? "" : "; ") + excess; }
  std::string text_;
};

}  // namespace

std::string size_reason(const Raster& reference, const Raster& test) {
  return fmt::format("size differs: {} x {} against {} x {}", reference.width, reference.height, test.width,
                     test.height);
}

std::string channels_reason(const Raster& reference, const Raster& test) {
  return fmt::format("channels differ: {} against {}", reference.channels, test.channels);
}

std::string not_finite_reason(const NotFinite& found) {
  std::string text;
  if (found.reference > 0) text = counted(found.reference, "sample") + " of the reference";
  if (found.test > 0)
    text += text.empty() ? counted(found.test, "sample") + " of the test picture"
                         : fmt::format(" and {} of the test picture", found.test);
  return fmt::format("{} {} NaN or infinite, first at pixel ({}, {})", text,
                     found.reference + found.test == 1 ? "is" : "are", found.first.x, found.first.y);
}

std::string tolerance_reason(const Tolerance& tolerance, const Measurements& measured) {
  Excesses excesses;
  excesses.at_most("RMSE", measured.error.root_mean_square, tolerance.rmse);
  if (tolerance.max && measured.error.largest > with_slack(*tolerance.max))
    excesses.at_most("largest difference", measured.error.largest, tolerance.max);
  excesses.pixels(measured.percent_over_threshold, measured.threshold, tolerance.pixels);
  if (measured.ssim) excesses.at_least("SSIM", *measured.ssim, tolerance.ssim);
  if (measured.flip) excesses.at_most("FLIP", *measured.flip, tolerance.flip);
  return excesses.text();
}

}  // namespace trace
