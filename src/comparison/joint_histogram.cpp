#include "comparison/joint_histogram.hpp"

namespace trace {

JointHistogram::JointHistogram(const PicturePair& pair) : cumulative_(256 * 257) {
  std::vector<std::uint32_t> counts(256 * 256);
  for (std::size_t i = 0; i < pair.test.rgb.size(); ++i)
    ++counts[static_cast<std::size_t>(pair.reference.rgb[i]) * 256 + pair.test.rgb[i]];
  for (std::size_t v = 0; v < 256; ++v)
    for (std::size_t t = 0; t < 256; ++t)
      cumulative_[v * 257 + t + 1] = cumulative_[v * 257 + t] + counts[v * 256 + t];
}

int JointHistogram::levels_that_moved() const {
  int levels = 0;
  for (int v = 0; v < 256; ++v) {
    const std::size_t stayed = between(v, std::max(1, v - 1), std::min(254, v + 1));
    levels += (between(v, 1, 254) - stayed) * 2 > below(v, 256);
  }
  return levels;
}

}  // namespace trace
