// A hash of every answer of a run, so that builds (compilers, instruction sets, sanitizers, thread counts)
// can be compared: equal digests are equal bits.
#pragma once

#include <bit>
#include <cstdint>

namespace trace::hard {

class Digest {
 public:
  // FNV-1a over 64-bit words in place of bytes, with a shift so that high bits reach the low ones.
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3u;
    value_ ^= value_ >> 29;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  // The answer to one ray: which primitive, and where.
  void add_hit(std::uint64_t primitive, double t) {
    add(primitive);
    add(t);
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace trace::hard
