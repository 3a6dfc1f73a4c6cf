// 8-bit samples as floating-point numbers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trace {

// Each n as n / 255.
inline std::vector<float> samples_of_bytes(std::span<const std::uint8_t> bytes) {
  std::array<float, 256> value{};
  for (std::size_t n = 0; n < value.size(); ++n) value[n] = float(n) / 255;
  std::vector<float> samples(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) samples[i] = value[bytes[i]];
  return samples;
}

}  // namespace trace
