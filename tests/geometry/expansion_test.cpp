#include "geometry/expansion.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/support/quad.hpp"

using namespace trace;
using trace::test::magnitude;
using trace::test::Quad;

namespace {

int sign(Quad x) {
  return x < 0 ? -1 : (x > 0 ? 1 : 0);
}

// Whole numbers of up to `bits` bits: what is made of a few of them is exact in 113 bits.
class Whole {
 public:
  explicit Whole(int bits) : bits_(bits) {}
  double operator()() {
    const auto size = static_cast<double>(engine_() >> (64 - bits_));
    return engine_() % 2 == 0 ? size : -size;
  }

 private:
  std::mt19937_64 engine_{7};
  int bits_;
};

}  // namespace

TEST_CASE("nothing is zero, and so is what cancels") {
  CHECK(Expansion().sign() == 0);
  CHECK(Expansion(0.0).sign() == 0);
  CHECK(Expansion(-0.0).sign() == 0);
  CHECK(Expansion().estimate() == 0);
  CHECK((Expansion(0.1) - Expansion(0.1)).sign() == 0);
  const Expansion third(1.0 / 3), tenth(0.1);
  CHECK((third * tenth - tenth * third).sign() == 0);
  CHECK((third * Expansion()).sign() == 0);
  CHECK((Expansion() * third).sign() == 0);
  CHECK((third + Expansion() - third).sign() == 0);
}

TEST_CASE("a difference keeps what rounding would lose") {
  const Expansion big = (Expansion(1e30) - Expansion(1e-30));
  CHECK(big.estimate() == 1e30);
  CHECK((big - 1e30).sign() == -1);
  CHECK((big - 1e30).estimate() == -1e-30);
  CHECK((big - 1e30 + 1e-30).sign() == 0);
}

TEST_CASE("the sign of the tiniest difference of products is exact") {
  constexpr double e = 0x1p-52;
  const auto product = [](double a, double b) { return Expansion(a) * Expansion(b); };
  // (1 + e)(1 - e) = 1 - e^2, which rounds to 1.
  CHECK((product(1 + e, 1 - e) - 1.0).sign() == -1);
  CHECK((product(1 + e, 1 - e) - 1.0).estimate() == -e * e);
  CHECK((product(1 + e, 1 + e) - Expansion(1 + 2 * e)).estimate() == e * e);
  // The product of three that differs from one of two by 2^-156 or not at all.
  const Expansion cube = product(1 + e, 1 + e) * Expansion(1 + e);
  const Expansion sum = Expansion(1) + 3 * e + product(3 * e, e);
  CHECK((cube - sum).sign() == 1);
  CHECK((cube - sum).estimate() == e * e * e);
  CHECK((cube - sum - product(e * e, e)).sign() == 0);
}

TEST_CASE("sums, differences and products of whole numbers are those of integers") {
  Whole whole(53);
  int wrong = 0;
  for (int i = 0; i < 10'000; ++i) {
    const double a = whole(), b = whole(), c = whole(), d = whole();
    const Quad determinant = Quad(a) * d - Quad(b) * c;  // of at most 107 bits: exact
    const Expansion same = Expansion(a) * Expansion(d) - Expansion(b) * Expansion(c);
    if (same.sign() != sign(determinant)) ++wrong;
    if (magnitude(same.estimate() - determinant) > magnitude(determinant) * 0x1p-51) ++wrong;
    // What is left beyond the double next to the determinant.
    const auto rounded = static_cast<double>(determinant);
    const Quad rest = determinant - rounded;
    if ((same - rounded).sign() != sign(rest) || (same - rounded).estimate() != static_cast<double>(rest))
      ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the sign of a volume of three edges is that of integers, zero included") {
  // Coordinates of 30 bits, differences of 31, products of three of at most 96.
  Whole whole(30);
  int wrong = 0, flat = 0;
  for (int i = 0; i < 10'000; ++i) {
    double p[4][3];
    for (auto& point : p) {
      for (double& coordinate : point) coordinate = whole();
    }
    if (i % 2 == 0) {
      // The fourth point in the plane of the others, or one step beside it.
      for (int k = 0; k < 3; ++k) p[3][k] = p[0][k] + 3 * (p[1][k] - p[0][k]) - 2 * (p[2][k] - p[0][k]);
      if (i % 4 == 0) p[3][i % 3] += i % 8 == 0 ? 1 : -1;
    }
    Quad q[3][3];
    Expansion x[3][3];
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        q[j][k] = Quad(p[j + 1][k]) - p[0][k];
        x[j][k] = (Expansion(p[j + 1][k]) - Expansion(p[0][k]));
      }
    }
    const auto volume = [](const auto& e) {
      return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
             e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
             e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    };
    const int expected = sign(volume(q));
    if (expected == 0) ++flat;
    if (volume(x).sign() != expected) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(flat >= 2'500);
}
