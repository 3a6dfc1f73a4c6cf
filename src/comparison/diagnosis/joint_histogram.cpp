#include "comparison/diagnosis/joint_histogram.hpp"

namespace trace {
namespace {

constexpr double least_move = 2;  // levels, see the header

}  // namespace

JointHistogram::JointHistogram(const PicturePair& pair) : cumulative_(256 * 257) {
  std::vector<std::uint32_t> counts(256 * 256);
  for (std::size_t i = 0; i < pair.test.rgb.size(); ++i)
    ++counts[static_cast<std::size_t>(pair.reference.rgb[i]) * 256 + pair.test.rgb[i]];
  for (std::size_t v = 0; v < 256; ++v)
    for (std::size_t t = 0; t < 256; ++t)
      cumulative_[v * 257 + t + 1] = cumulative_[v * 257 + t] + counts[v * 256 + t];
}

std::vector<MovedLevel> JointHistogram::moved_levels() const {
  std::vector<MovedLevel> levels;
  for (int v = 0; v < 255; ++v) {
    const std::size_t all = below(v, 256);
    if (all == 0 || between(v, 1, 254) * 2 <= all) continue;
    double sum = 0;
    for (int t = 1; t < 256; ++t) sum += t * static_cast<double>(between(v, t, t));
    const double mean = sum / static_cast<double>(all);
    if (std::abs(mean - v) > least_move) levels.push_back({v, mean, all});
  }
  return levels;
}

}  // namespace trace
