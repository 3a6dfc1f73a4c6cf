// A set of colour channels.
#pragma once

#include <cstdint>

namespace trace {

// Channels are 0 (red), 1 (green) and 2 (blue).
class Channels {
 public:
  constexpr Channels() = default;
  constexpr explicit Channels(int channel) : bits_(static_cast<std::uint8_t>(1 << channel)) {}

  constexpr bool any() const { return bits_ != 0; }
  constexpr bool has(int channel) const { return (bits_ >> channel & 1) != 0; }

  constexpr Channels& operator|=(Channels other) {
    bits_ = static_cast<std::uint8_t>(bits_ | other.bits_);
    return *this;
  }
  friend constexpr Channels operator|(Channels a, Channels b) { return a |= b; }
  friend constexpr bool operator==(Channels, Channels) = default;

 private:
  std::uint8_t bits_ = 0;
};

}  // namespace trace
