#include "geometry/expansion.hpp"

#include <cmath>

namespace trace {
namespace {

struct Pair {
  double value, error;  // value + error is exact
};

// Knuth's sum of two numbers in any order.
Pair two_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a, of_a = sum - of_b;
  return {sum, (a - of_a) + (b - of_b)};
}

Pair two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

}  // namespace

Expansion Expansion::difference(double a, double b) {
  const Pair pair = two_sum(a, -b);
  Expansion result;
  result.append(pair.error);
  result.append(pair.value);
  return result;
}

// Shewchuk's GROW-EXPANSION, in place: what is written never overtakes what is read.
void Expansion::add(double b) {
  const std::size_t count = size_;
  size_ = 0;
  double carry = b;
  for (std::size_t i = 0; i < count; ++i) {
    const Pair sum = two_sum(carry, terms_[i]);
    append(sum.error);
    carry = sum.value;
  }
  append(carry);
}

// Shewchuk's SCALE-EXPANSION.
Expansion Expansion::times(double b) const {
  Expansion result;
  if (size_ == 0) return result;
  Pair carry = two_product(terms_[0], b);
  result.append(carry.error);
  for (std::size_t i = 1; i < size_; ++i) {
    const Pair product = two_product(terms_[i], b);
    const Pair low = two_sum(carry.value, product.error);
    result.append(low.error);
    const Pair high = two_sum(product.value, low.value);
    result.append(high.error);
    carry.value = high.value;
  }
  result.append(carry.value);
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
