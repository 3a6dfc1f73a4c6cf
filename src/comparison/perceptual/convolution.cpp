#include "comparison/perceptual/convolution.hpp"

#include <algorithm>
#include <cstring>

#include "comparison/vector_clones.hpp"

namespace trace {
namespace {

// Eight numbers at a time, 32 in flight: a vector type of GCC and clang, whose operations are those of the
// single numbers. What is added first is the same for every pixel, whatever the machine's vectors.
using Eight = float __attribute__((vector_size(32)));
constexpr std::size_t block = 32;
static_assert(block == Plane::spare);

// A row of results; tap k reads `step` numbers behind tap k - 1.
TRACE_VECTOR_CLONES void filter(const float* in, std::size_t step, const float* taps, std::size_t tap_count,
                                float* __restrict out, std::size_t width) {
  for (std::size_t x = 0; x < width; x += block) {
    Eight a{}, b{}, c{}, d{}, p, q, r, s;
    const float* from = in + x;
    for (std::size_t k = 0; k < tap_count; ++k, from += step) {
      const float tap = taps[k];
      std::memcpy(&p, from, sizeof p);
      std::memcpy(&q, from + 8, sizeof q);
      std::memcpy(&r, from + 16, sizeof r);
      std::memcpy(&s, from + 24, sizeof s);
      a += tap * p;
      b += tap * q;
      c += tap * r;
      d += tap * s;
    }
    std::memcpy(out + x, &a, sizeof a);
    std::memcpy(out + x + 8, &b, sizeof b);
    std::memcpy(out + x + 16, &c, sizeof c);
    std::memcpy(out + x + 24, &d, sizeof d);
  }
}

}  // namespace

void filter_rows(const Plane& in, std::span<const float> taps, Plane& out) {
  out.resize(in.width() - static_cast<int>(taps.size()) + 1, in.height());
  for (int y = 0; y < out.height(); ++y)
    filter(in.row(y), 1, taps.data(), taps.size(), out.row(y), static_cast<std::size_t>(out.width()));
}

void filter_columns(const Plane& in, std::span<const float> taps, Plane& out) {
  out.resize(in.width(), in.height() - static_cast<int>(taps.size()) + 1);
  for (int y = 0; y < out.height(); ++y)
    filter(in.row(y), in.stride(), taps.data(), taps.size(), out.row(y),
           static_cast<std::size_t>(out.width()));
}

void cut(const Plane& in, int margin, Plane& out) {
  out.resize(in.width() - 2 * margin, in.height() - 2 * margin);
  for (int y = 0; y < out.height(); ++y) std::copy_n(in.row(y + margin) + margin, out.width(), out.row(y));
}

}  // namespace trace
