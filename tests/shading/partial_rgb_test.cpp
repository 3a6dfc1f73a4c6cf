#include "shading/partial_rgb.hpp"

#include "shading/transmittance.hpp"
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using trace::test::infinity;

namespace {

const double numbers[] = {0.0, -0.0, 1.0, -2.5, 5e-324, 1e308, -1e308, infinity, -infinity};

// `result` in every channel against what IEEE arithmetic makes of the same numbers: NaN is undefined.
bool agrees(const PartialRgb& result, const Rgb& plain) {
  for (int c = 0; c < 3; ++c) {
    const bool undefined = std::isnan(plain[c]);
    if (result.undefined.has(c) != undefined) return false;
    if (undefined ? result.value[c] != 0
                  : result.value[c] != plain[c] || std::signbit(result.value[c]) != std::signbit(plain[c]))
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a channel is undefined exactly where plain arithmetic has no number, and has its bits elsewhere") {
  for (const double a : numbers) {
    for (const double b : numbers) {
      for (const double c : numbers) {
        const Rgb x(a, b, c), y(b, c, a);
        CAPTURE(a, b, c);
        REQUIRE(agrees(PartialRgb(x) * PartialRgb(y), x * y));
        REQUIRE(agrees(PartialRgb(x) + PartialRgb(y), x + y));
      }
    }
  }
}

TEST_CASE("a channel once undefined stays so, even times 0, and its value is 0") {
  const PartialRgb unknown(Rgb(1, 0, 3), Channels(1));
  for (const double n : numbers) {
    CHECK((unknown * Rgb(n)).undefined.has(1));
    CHECK((Rgb(n) * unknown).undefined.has(1));
    CHECK((unknown + Rgb(n)).undefined.has(1));
    CHECK((Rgb(n) + unknown).value.y == 0);
  }
  const PartialRgb sum = unknown + Rgb(5);
  CHECK(sum.value == Rgb(6, 0, 8));
  CHECK(sum.undefined == Channels(1));
  CHECK((unknown * PartialRgb(Rgb(2), Channels(2))).undefined == (Channels(1) | Channels(2)));
  CHECK_FALSE(unknown.finite());
  CHECK_FALSE(PartialRgb(Rgb(0, infinity, 0)).finite());
  CHECK(PartialRgb(Rgb(-1, 0, 1e308)).finite());
}

TEST_CASE("transmittance is kt to the power of the way, undefined for broken powers of negative numbers") {
  CHECK(transmittance(Rgb(0.5, 0.25, 1), 2).value == Rgb(0.25, 0.0625, 1));
  CHECK(transmittance(Rgb(0.5, 0, 4), 0).value == Rgb(1));
  const PartialRgb miss = transmittance(Rgb(0.5, 0, -4), length_of_miss);
  CHECK(miss.value == Rgb(2, infinity, -0.25));
  CHECK_FALSE(miss.undefined.any());
  CHECK(transmittance(Rgb(-0.5, -2, 0), 2).value == Rgb(0.25, 4, 0));
  const PartialRgb broken = transmittance(Rgb(-0.5, 0.25, -0.0), 0.5);
  CHECK(broken.value == Rgb(0, 0.5, 0));
  CHECK(broken.undefined == Channels(0));
  const PartialRgb huge = transmittance(Rgb(1e300, -1e300, 1), 2);
  CHECK(huge.value == Rgb(infinity, infinity, 1));
  CHECK_FALSE(huge.undefined.any());
}

TEST_CASE(
    "a miss through kt = 0 is infinite before a background with light and undefined before a black one") {
  const PartialRgb seen = transmittance(Rgb(0.5, 0, 0), length_of_miss) * Rgb(0.1, 0.1, 0);
  CHECK(seen.value == Rgb(0.2, infinity, 0));
  CHECK(seen.undefined == Channels(2));
}
