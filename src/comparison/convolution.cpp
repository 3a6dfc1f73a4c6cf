#include "comparison/convolution.hpp"

#include <algorithm>
#include <cstring>

namespace trace {
namespace {

// Four numbers at a time, sixteen in flight: a vector type of GCC and clang, whose operations are those of
// the single numbers. What is added first is the same for every pixel, whatever the vectors' size.
using Four = float __attribute__((vector_size(16)));
constexpr std::size_t block = 16;

Four load(const float* from) {
  Four values;
  std::memcpy(&values, from, sizeof values);
  return values;
}

void store(float* to, Four values) {
  std::memcpy(to, &values, sizeof values);
}

// A row of results; tap k reads `step` numbers behind tap k - 1.
void filter(const float* in, std::size_t step, std::span<const float> taps, float* out, int width) {
  for (std::size_t x = 0; x < static_cast<std::size_t>(width); x += block) {
    Four a{}, b{}, c{}, d{};
    const float* from = in + x;
    for (const float tap : taps) {
      a += tap * load(from);
      b += tap * load(from + 4);
      c += tap * load(from + 8);
      d += tap * load(from + 12);
      from += step;
    }
    store(out + x, a);
    store(out + x + 4, b);
    store(out + x + 8, c);
    store(out + x + 12, d);
  }
}

}  // namespace

void filter_rows(const Plane& in, std::span<const float> taps, Plane& out) {
  out.resize(in.width() - static_cast<int>(taps.size()) + 1, in.height());
  for (int y = 0; y < out.height(); ++y) filter(in.row(y), 1, taps, out.row(y), out.width());
}

void filter_columns(const Plane& in, std::span<const float> taps, Plane& out) {
  out.resize(in.width(), in.height() - static_cast<int>(taps.size()) + 1);
  for (int y = 0; y < out.height(); ++y) filter(in.row(y), in.stride(), taps, out.row(y), out.width());
}

void cut(const Plane& in, int margin, Plane& out) {
  out.resize(in.width() - 2 * margin, in.height() - 2 * margin);
  for (int y = 0; y < out.height(); ++y) std::copy_n(in.row(y + margin) + margin, out.width(), out.row(y));
}

}  // namespace trace
