#include "comparison/pixel_differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "comparison/background.hpp"

namespace trace {
namespace {

constexpr float greatest = std::numeric_limits<float>::max();

class FirstPass {
 public:
  FirstPass(const Raster& reference, const Raster& test)
      : reference_(reference),
        test_(test),
        width_(static_cast<std::size_t>(reference.width)),
        channels_(static_cast<std::size_t>(reference.channels)),
        background_(background_of(reference)),
        is_foreground_(width_),
        reference_row_(width_ * channels_),
        test_row_(width_ * channels_) {
    result_.unit = common_unit(reference, test);
    result_.channel.resize(channels_);
    result_.levels.resize(width_ * static_cast<std::size_t>(reference.height));
    result_.row_differs.resize(static_cast<std::size_t>(reference.height));
  }

  PixelDifferences run() {
    for (int y = 0; y < reference_.height; ++y) row(y);
    return std::move(result_);
  }

 private:
  void row(int y) {
    find_foreground(y);
    const bool finite = result_.unit.whole || check_finite(y);
    for (ErrorSum& sum : result_.channel) sum.count += width_;
    const std::size_t bytes = width_ * channels_ * sizeof(float);
    const bool equal = std::memcmp(reference_.pixel(0, y), test_.pixel(0, y), bytes) == 0;
    if (equal && finite) return;
    load_row(reference_, y, result_.unit, reference_row_, width_);
    load_row(test_, y, result_.unit, test_row_, width_);
    float* levels = &result_.levels[static_cast<std::size_t>(y) * width_];
    if (!finite) leave_out(levels);
    for (std::size_t channel = 0; channel < channels_; ++channel) add(channel, y, levels);
    const auto differs = [](float difference) { return difference != 0; };
    result_.row_differs[static_cast<std::size_t>(y)] = std::any_of(levels, levels + width_, differs);
  }

  void find_foreground(int y) {
    const float* r = reference_.pixel(0, y);
    const float* t = test_.pixel(0, y);
    std::size_t pixels = 0;
    for (std::size_t x = 0; x < width_; ++x, r += channels_, t += channels_) {
      bool same = true;
      for (std::size_t c = 0; c < channels_; ++c) same &= r[c] == background_[c] && t[c] == background_[c];
      is_foreground_[x] = !same;
      pixels += !same;
    }
    result_.foreground_pixels += pixels;
    result_.foreground_samples += pixels * channels_;
  }

  // Counts samples that are not finite; true if there is none.
  bool check_finite(int y) {
    const float* r = reference_.pixel(0, y);
    const float* t = test_.pixel(0, y);
    NotFinite& found = result_.not_finite;
    bool finite = true;
    for (std::size_t i = 0; i < width_ * channels_; ++i) {
      if (std::isfinite(r[i]) && std::isfinite(t[i])) continue;
      if (found.reference + found.test == 0) found.first = {static_cast<int>(i / channels_), y};
      found.reference += !std::isfinite(r[i]);
      found.test += !std::isfinite(t[i]);
      finite = false;
    }
    return finite;
  }

  // Makes samples equal that are not finite in either row, and takes them out of the counts.
  void leave_out(float* levels) {
    for (std::size_t i = 0; i < width_ * channels_; ++i) {
      if (std::isfinite(reference_row_[i]) && std::isfinite(test_row_[i])) continue;
      reference_row_[i] = test_row_[i] = 0;
      const std::size_t x = i % width_;
      --result_.channel[i / width_].count;
      result_.foreground_samples -= static_cast<std::size_t>(is_foreground_[x]);
      levels[x] = left_out;
    }
  }

  void add(std::size_t channel, int y, float* levels) {
    const float* r = &reference_row_[channel * width_];
    const float* t = &test_row_[channel * width_];
    const auto per_unit = static_cast<float>(result_.unit.levels(1));
    ErrorSum all;
    for (std::size_t x = 0; x < width_; ++x) {
      const float difference = std::clamp(t[x] - r[x], -greatest, greatest);
      if (difference == 0) continue;
      all.add(static_cast<double>(difference));
      if (levels[x] == left_out) continue;
      levels[x] = std::max(levels[x], std::min(std::abs(difference) * per_unit, greatest));
    }
    if (all.largest > largest_) note_largest(static_cast<int>(channel), y, all.largest);
    result_.channel[channel] += all;
  }

  void note_largest(int channel, int y, double size) {
    const float* r = &reference_row_[static_cast<std::size_t>(channel) * width_];
    const float* t = &test_row_[static_cast<std::size_t>(channel) * width_];
    std::size_t x = 0;
    while (static_cast<double>(std::abs(std::clamp(t[x] - r[x], -greatest, greatest))) != size) ++x;
    largest_ = size;
    result_.largest = {{static_cast<int>(x), y},
                       channel,
                       result_.unit.levels(static_cast<double>(r[x])),
                       result_.unit.levels(static_cast<double>(t[x]))};
  }

  const Raster& reference_;
  const Raster& test_;
  std::size_t width_, channels_;
  std::vector<float> background_;
  std::vector<char> is_foreground_;  // of the row in hand
  std::vector<float> reference_row_, test_row_;
  double largest_ = 0;  // in units
  PixelDifferences result_;
};

}  // namespace

PixelDifferences pixel_differences(const Raster& reference, const Raster& test) {
  return FirstPass(reference, test).run();
}

}  // namespace trace
