#include "comparison/pixel_differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "comparison/background.hpp"
#include "comparison/row_sums.hpp"
#include "parallel/parallel.hpp"

namespace trace {
namespace {

constexpr float greatest = std::numeric_limits<float>::max();
constexpr int band_height = 64;  // rows that are summed in one go, whatever the number of threads

// The same as `std::isfinite` of each, several at once.
bool all_finite(const float* samples, std::size_t count) {
  int beyond = 0;
  for (std::size_t i = 0; i < count; ++i) beyond |= !(std::abs(samples[i]) <= greatest);
  return beyond == 0;
}

// A band of rows. The vectors of all pixels are shared, each band writes its own rows of them.
class Band {
 public:
  Band(const Raster& reference, const Raster& test, const std::vector<float>& background,
       PixelDifferences& all)
      : reference_(reference),
        test_(test),
        background_(background),
        all_(all),
        width_(static_cast<std::size_t>(reference.width)),
        stride_((width_ + row_block - 1) / row_block * row_block),
        channels_(static_cast<std::size_t>(reference.channels)),
        is_foreground_(width_),
        reference_row_(stride_ * channels_),
        test_row_(stride_ * channels_),
        levels_(stride_) {
    own_.unit = all.unit;
    own_.channel.resize(channels_);
  }

  // Figures without `levels` and `row_differs`.
  PixelDifferences run(int from, int to) {
    for (int y = from; y < to; ++y) row(y);
    return std::move(own_);
  }

 private:
  void row(int y) {
    find_foreground(y);
    const bool finite = check_finite(y);
    for (ErrorSum& sum : own_.channel) sum.count += width_;
    const std::size_t bytes = width_ * channels_ * sizeof(float);
    const bool equal = std::memcmp(reference_.pixel(0, y), test_.pixel(0, y), bytes) == 0;
    if (equal && finite) return;
    load_row(reference_, y, own_.unit, reference_row_, stride_);
    load_row(test_, y, own_.unit, test_row_, stride_);
    std::fill(levels_.begin(), levels_.end(), 0.0F);
    if (!finite) leave_out();
    for (std::size_t channel = 0; channel < channels_; ++channel) add(channel, y);
    std::copy_n(levels_.begin(), width_, &all_.levels[static_cast<std::size_t>(y) * width_]);
    const auto differs = [](float difference) { return difference != 0; };
    all_.row_differs[static_cast<std::size_t>(y)] = std::any_of(levels_.begin(), levels_.end(), differs);
  }

  void find_foreground(int y) {
    const float* r = reference_.pixel(0, y);
    const float* t = test_.pixel(0, y);
    std::size_t pixels = 0;
    for (std::size_t x = 0; x < width_; ++x, r += channels_, t += channels_) {
      bool same = true;
      for (std::size_t c = 0; same && c < channels_; ++c)
        same = r[c] == background_[c] && t[c] == background_[c];
      is_foreground_[x] = !same;
      pixels += !same;
    }
    own_.foreground_pixels += pixels;
    own_.foreground_samples += pixels * channels_;
  }

  // Counts samples that are not finite; true if there is none.
  bool check_finite(int y) {
    const float* r = reference_.pixel(0, y);
    const float* t = test_.pixel(0, y);
    if (all_finite(r, width_ * channels_) && all_finite(t, width_ * channels_)) return true;
    NotFinite& found = own_.not_finite;
    for (std::size_t i = 0; i < width_ * channels_; ++i) {
      if (std::isfinite(r[i]) && std::isfinite(t[i])) continue;
      if (found.reference + found.test == 0) found.first = {static_cast<int>(i / channels_), y};
      found.reference += !std::isfinite(r[i]);
      found.test += !std::isfinite(t[i]);
    }
    return false;
  }

  // Makes samples equal that are not finite in either row, and takes them out of the counts.
  void leave_out() {
    for (std::size_t channel = 0; channel < channels_; ++channel)
      for (std::size_t x = 0; x < width_; ++x) {
        float& r = reference_row_[channel * stride_ + x];
        float& t = test_row_[channel * stride_ + x];
        if (std::isfinite(r) && std::isfinite(t)) continue;
        r = t = 0;
        --own_.channel[channel].count;
        own_.foreground_samples -= static_cast<std::size_t>(is_foreground_[x]);
        levels_[x] = left_out;
      }
  }

  void add(std::size_t channel, int y) {
    const float* r = &reference_row_[channel * stride_];
    const float* t = &test_row_[channel * stride_];
    const ErrorSum sum = sum_row(r, t, static_cast<float>(own_.unit.levels(1)), levels_.data(), stride_);
    if (sum.largest > own_.largest_units) note_largest(static_cast<int>(channel), y, r, t, sum.largest);
    own_.channel[channel] += sum;
  }

  void note_largest(int channel, int y, const float* r, const float* t, double size) {
    std::size_t x = 0;
    while (static_cast<double>(std::min(std::abs(t[x] - r[x]), greatest)) != size) ++x;
    own_.largest_units = size;
    own_.largest = {{static_cast<int>(x), y},
                    channel,
                    own_.unit.levels(static_cast<double>(r[x])),
                    own_.unit.levels(static_cast<double>(t[x]))};
  }

  const Raster& reference_;
  const Raster& test_;
  const std::vector<float>& background_;
  PixelDifferences& all_;
  std::size_t width_, stride_, channels_;
  std::vector<char> is_foreground_;                       // of the row in hand
  std::vector<float> reference_row_, test_row_, levels_;  // likewise
  PixelDifferences own_;
};

void append(PixelDifferences& all, const PixelDifferences& band) {
  for (std::size_t c = 0; c < all.channel.size(); ++c) all.channel[c] += band.channel[c];
  all.foreground_pixels += band.foreground_pixels;
  all.foreground_samples += band.foreground_samples;
  if (all.not_finite.reference + all.not_finite.test == 0) all.not_finite.first = band.not_finite.first;
  all.not_finite.reference += band.not_finite.reference;
  all.not_finite.test += band.not_finite.test;
  if (band.largest_units > all.largest_units) {
    all.largest_units = band.largest_units;
    all.largest = band.largest;
  }
}

}  // namespace

PixelDifferences pixel_differences(const Raster& reference, const Raster& test, unsigned threads) {
  PixelDifferences all;
  all.unit = common_unit(reference, test);
  all.channel.resize(static_cast<std::size_t>(reference.channels));
  all.levels.resize(static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height));
  all.row_differs.resize(static_cast<std::size_t>(reference.height));
  const std::vector<float> background = background_of(reference);
  std::vector<PixelDifferences> bands(
      static_cast<std::size_t>((reference.height + band_height - 1) / band_height));
  parallel_for(static_cast<int>(threads), bands.size(), [&](std::size_t i, int) {
    const int from = static_cast<int>(i) * band_height;
    const int to = std::min(from + band_height, reference.height);
    bands[i] = Band(reference, test, background, all).run(from, to);
  });
  for (const PixelDifferences& band : bands) append(all, band);
  return all;
}

}  // namespace trace
