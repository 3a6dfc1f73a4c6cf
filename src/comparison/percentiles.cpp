#include "comparison/percentiles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace trace {
namespace {

// Numbers that are not negative are ordered as their bits are. The upper half of the bits tells whole numbers
// below 256 apart, so that few values are left to be ordered in full.
constexpr std::size_t bins = 0x8000;

std::size_t bin_of(float value) {
  return std::bit_cast<std::uint32_t>(value) >> 16;
}

class Ranks {
 public:
  explicit Ranks(std::span<const float> values) : values_(values), counts_(bins) {
    for (float value : values)
      if (value >= 0) ++counts_[bin_of(value)], ++count_;
  }

  // `rank` counts from 1.
  double operator()(std::size_t rank) const {
    std::size_t bin = 0;
    while (rank > counts_[bin]) rank -= counts_[bin++];
    if (bin == 0) return 0;  // nothing in it but 0 (and numbers below 1e-40)
    std::vector<float> same;
    same.reserve(counts_[bin]);
    for (float value : values_)
      if (value >= 0 && bin_of(value) == bin) same.push_back(value);
    const auto found = same.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(same.begin(), found, same.end());
    return static_cast<double>(*found);
  }

  // In thousandths, which are exact.
  double percentile(std::size_t thousandths) const {
    if (count_ == 0) return 0;
    return (*this)(std::max<std::size_t>(1, (thousandths * count_ + 999) / 1000));
  }

 private:
  std::span<const float> values_;
  std::vector<std::uint32_t> counts_;
  std::size_t count_ = 0;
};

}  // namespace

Percentiles percentiles(std::span<const float> differences) {
  const Ranks ranks(differences);
  return {ranks.percentile(500), ranks.percentile(900), ranks.percentile(990), ranks.percentile(999)};
}

}  // namespace trace
