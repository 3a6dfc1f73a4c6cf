// The figures of error against truth computed by hand.
#include <catch2/catch.hpp>
#include <cmath>

#include "comparison/measure.hpp"
#include "rasters.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("one level is one level in both directions") {
  const Raster three = uniform(2, 2, 3, 3), four = uniform(2, 2, 3, 4);
  const Measurements up = measure(three, four), down = measure(four, three);
  CHECK(up.error.root_mean_square == 1);
  CHECK(down.error.root_mean_square == 1);
  CHECK(up.error.mean_signed == 1);
  CHECK(down.error.mean_signed == -1);
  CHECK(up.error.largest == 1);
  CHECK(down.error.largest == 1);
}

TEST_CASE("black against white is 255 levels") {
  const Measurements m = measure(uniform(3, 2, 3, 0), uniform(3, 2, 3, 255));
  CHECK(m.error.root_mean_square == 255);
  CHECK(m.error.mean_absolute == 255);
  CHECK(m.error.peak_signal_to_noise == Approx(0).margin(1e-12));
  CHECK(m.percent_different == 100);
}

TEST_CASE("errors over all channels and of each") {
  // Differences: 3, 0, -4 and 0, 0, 0.
  const Raster reference = levels(2, 1, 3, {10, 20, 30, 40, 50, 60});
  const Raster test = levels(2, 1, 3, {13, 20, 26, 40, 50, 60});
  const Measurements m = measure(reference, test);
  CHECK(m.error.mean_absolute == Approx(7.0 / 6));
  CHECK(m.error.mean_signed == Approx(-1.0 / 6));
  CHECK(m.error.root_mean_square == Approx(std::sqrt(25.0 / 6)));
  CHECK(m.error.peak_signal_to_noise == Approx(20 * std::log10(255 / std::sqrt(25.0 / 6))));
  REQUIRE(m.channel.size() == 3);
  CHECK(m.channel[0].mean_signed == 1.5);
  CHECK(m.channel[0].root_mean_square == Approx(std::sqrt(4.5)));
  CHECK(m.channel[1].root_mean_square == 0);
  CHECK(std::isinf(m.channel[1].peak_signal_to_noise));
  CHECK(m.channel[2].largest == 4);
  CHECK(m.percent_different == 50);
  CHECK(m.percent_over_one == 50);
}

TEST_CASE("the largest difference has its pixel, channel and both values") {
  Raster reference = uniform(5, 4, 3, 100), test = uniform(5, 4, 3, 100);
  set(test, 1, 0, 0, 109);
  set(test, 3, 2, 1, 70);
  const Measurements m = measure(reference, test);
  CHECK(m.largest.pixel.x == 3);
  CHECK(m.largest.pixel.y == 2);
  CHECK(m.largest.channel == 1);
  CHECK(m.largest.reference == 100);
  CHECK(m.largest.test == 70);
}

TEST_CASE("a pixel off by exactly the threshold is not over it, in any type of sample") {
  MeasureOptions options;
  options.threshold = 2;
  // Every level from 0: rounding differs from one to the next.
  for (int level = 0; level < 254; ++level) {
    const Raster a = uniform(1, 1, 3, level), one = uniform(1, 1, 3, level + 1),
                 two = uniform(1, 1, 3, level + 2);
    CHECK(measure(a, one, options).percent_over_one == 0);
    CHECK(measure(a, two, options).percent_over_one == 100);
    CHECK(measure(a, two, options).percent_over_threshold == 0);
    Raster a16 = a, one16 = one, areal = a, onereal = one;
    a16.type = one16.type = SampleType::uint16;
    areal.type = onereal.type = SampleType::real;
    CHECK(measure(a16, one16, options).error.largest == 1);
    CHECK(measure(a16, one16, options).percent_over_one == 0);
    CHECK(measure(areal, onereal, options).percent_over_one == 0);
  }
}

TEST_CASE("a step of 16 bits is 1/257 of a level") {
  Raster a{1, 1, 1, SampleType::uint16, {1000.0F / 65535}};
  Raster b{1, 1, 1, SampleType::uint16, {1001.0F / 65535}};
  CHECK(measure(a, b).error.largest == Approx(1.0 / 257).epsilon(1e-12));
  CHECK(measure(a, b).percent_different == 100);
}

TEST_CASE("8 bits against the same in 16 bits are identical") {
  for (int level = 0; level < 256; ++level) {
    Raster wide{1, 1, 1, SampleType::uint16, {static_cast<float>(257 * level) / 65535}};
    CHECK(measure(uniform(1, 1, 1, level), wide).identical());
  }
}

TEST_CASE("floating-point pictures are measured outside of [0, 1] too") {
  const Measurements m = measure(floats(2, 1, 1, {-1, 3}), floats(2, 1, 1, {1, 3}));
  CHECK(m.error.largest == 510);
  CHECK(m.largest.reference == -255);
  CHECK(m.largest.test == 255);
}

TEST_CASE("the greatest numbers there are do not become infinite differences") {
  const float most = std::numeric_limits<float>::max();
  const Measurements m = measure(floats(1, 1, 1, {-most}), floats(1, 1, 1, {most}));
  CHECK(std::isfinite(m.error.root_mean_square));
  CHECK(m.error.largest > 1e38);
  CHECK_FALSE(m.identical());
  CHECK(std::isfinite(m.edge_tolerant.largest));
  CHECK(*m.flip > 0.9);
}

TEST_CASE("identical pictures measure 0, and 1 for SSIM") {
  const Raster picture = noise(20, 20, 1);
  const Measurements m = measure(picture, picture);
  CHECK(m.identical());
  CHECK(m.error.root_mean_square == 0);
  CHECK(std::isinf(m.error.peak_signal_to_noise));
  CHECK(m.percent_different == 0);
  CHECK(m.percentiles.p999 == 0);
  CHECK(m.ssim == 1.0);
  CHECK(m.flip == 0.0);
  CHECK(m.edge_tolerant.largest == 0);
  CHECK(m.worst.empty());
  CHECK(m.foreground.pixels == 400);
}

TEST_CASE("SSIM and FLIP are absent where they are not asked for") {
  MeasureOptions options;
  options.ssim = options.flip = false;
  const Measurements different = measure(noise(20, 20, 1), noise(20, 20, 2), options);
  CHECK_FALSE(different.ssim);
  CHECK_FALSE(different.flip);
  CHECK_FALSE(measure(noise(20, 20, 1), noise(20, 20, 1), options).ssim);
}

TEST_CASE("alpha counts in errors but not in SSIM and FLIP") {
  const Raster a = levels(1, 1, 4, {10, 20, 30, 255}), b = levels(1, 1, 4, {10, 20, 30, 0});
  const Measurements m = measure(a, b);
  CHECK(m.error.largest == 255);
  CHECK(m.channel[3].root_mean_square == 255);
  CHECK(m.ssim == 1.0);
  CHECK(*m.flip == Approx(0).margin(1e-9));
}

TEST_CASE("every figure is the same for any number of threads") {
  const Raster a = noise(300, 270, 1), b = noise(300, 270, 2);
  MeasureOptions one, five;
  one.threads = 1;
  five.threads = 5;
  const Measurements m = measure(a, b, one), n = measure(a, b, five);
  CHECK(*m.ssim == *n.ssim);
  CHECK(*m.flip == *n.flip);
  CHECK(m.error.root_mean_square == n.error.root_mean_square);
  CHECK(m.edge_tolerant.root_mean_square == n.edge_tolerant.root_mean_square);
}
