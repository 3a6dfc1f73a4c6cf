// Exact sums and products of doubles: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", Discrete & Computational Geometry 18 (1997).
//
// A value is held as a sum of doubles that do not overlap, smallest first, without zeros. Every operation is
// exact as long as nothing overflows or underflows. Meant for the rare case that rounding could decide wrong.
#pragma once

#include <algorithm>
#include <array>

namespace trace {

class Expansion {
 public:
  Expansion() = default;
  Expansion(const Expansion& other) { *this = other; }
  Expansion& operator=(const Expansion& other) {
    size_ = other.size_;
    std::copy_n(other.terms_.begin(), size_, terms_.begin());
    return *this;
  }
  Expansion(double value) { append(value); }  // NOLINT: a double is one

  friend Expansion operator+(const Expansion& a, const Expansion& b);
  friend Expansion operator-(const Expansion& a, const Expansion& b);
  friend Expansion operator*(const Expansion& a, const Expansion& b);
  Expansion operator-() const;

  // -1, 0 or 1
  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0 ? 1 : -1); }

  // The nearest double but for an error of about one unit in the last place.
  double estimate() const;

 private:
  // Enough for three sums of three products of a double and two differences, less two such products: 3 * 3 *
  // 2 * 16; and for the sum of three products of three differences, 3 * 64.
  static constexpr std::size_t max_terms = 288;

  void append(double term) {
    if (term != 0) terms_[size_++] = term;
  }
  void add(double b);
  Expansion times(double b) const;

  std::array<double, max_terms> terms_;  // only the first size_ are set
  std::size_t size_ = 0;
};

}  // namespace trace
