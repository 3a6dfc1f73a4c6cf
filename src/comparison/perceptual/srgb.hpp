// sRGB's transfer function (IEC 61966-2-1): from what is stored to linear light.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace trace {

inline float linear_of_srgb(float stored) {
  const auto c = static_cast<double>(stored);
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

// The same for whole levels only, from a table.
class LinearOfLevel {
 public:
  LinearOfLevel() {
    for (std::size_t n = 0; n < table_.size(); ++n) table_[n] = linear_of_srgb(static_cast<float>(n) / 255);
  }
  float operator()(float stored) const {
    return table_[static_cast<std::uint8_t>(static_cast<int>(stored * 255 + 0.5F))];
  }

 private:
  std::array<float, 256> table_{};
};

}  // namespace trace
