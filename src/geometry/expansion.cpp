#include "geometry/expansion.hpp"

#include "geometry/double_double.hpp"

namespace trace {

// Shewchuk's GROW-EXPANSION, in place: what is written never overtakes what is read.
void Expansion::add(double b) {
  const std::size_t count = size_;
  size_ = 0;
  double carry = b;
  for (std::size_t i = 0; i < count; ++i) {
    const DoubleDouble sum = exact_sum(carry, terms_[i]);
    append(sum.low);
    carry = sum.high;
  }
  append(carry);
}

// Shewchuk's SCALE-EXPANSION.
Expansion Expansion::times(double b) const {
  Expansion result;
  if (size_ == 0) return result;
  DoubleDouble carry = exact_product(terms_[0], b);
  result.append(carry.low);
  for (std::size_t i = 1; i < size_; ++i) {
    const DoubleDouble product = exact_product(terms_[i], b);
    const DoubleDouble low = exact_sum(carry.high, product.low);
    result.append(low.low);
    const DoubleDouble high = exact_sum(product.high, low.high);
    result.append(high.low);
    carry.high = high.high;
  }
  result.append(carry.high);
  return result;
}

Expansion operator+(const Expansion& a, const Expansion& b) {
  Expansion result = a;
  for (std::size_t i = 0; i < b.size_; ++i) result.add(b.terms_[i]);
  return result;
}

Expansion Expansion::operator-() const {
  Expansion result;
  for (std::size_t i = 0; i < size_; ++i) result.append(-terms_[i]);
  return result;
}

Expansion operator-(const Expansion& a, const Expansion& b) {
  return a + -b;
}

Expansion operator*(const Expansion& a, const Expansion& b) {
  Expansion result;
  for (std::size_t i = 0; i < b.size_; ++i) {
    const Expansion part = a.times(b.terms_[i]);
    for (std::size_t j = 0; j < part.size_; ++j) result.add(part.terms_[j]);
  }
  return result;
}

double Expansion::estimate() const {
  double sum = 0;
  for (std::size_t i = 0; i < size_; ++i) sum += terms_[i];
  return sum;
}

}  // namespace trace
