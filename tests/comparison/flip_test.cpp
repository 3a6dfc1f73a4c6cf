#include "comparison/perceptual/flip.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "comparison/measure.hpp"
#include "rasters.hpp"
#include "tests/support/picture_table.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const std::filesystem::path shared = std::filesystem::path(TRACE_SOURCE_DIR) / "../shared";

struct Lab {
  double l, a, b;
};

// CIE L*a*b* of linear sRGB, a* and b* scaled by 0.01 L*.
Lab hunt(double r, double g, double b) {
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29; };
  const double x = f((0.4123908 * r + 0.3575843 * g + 0.1804808 * b) / 0.9504559);
  const double y = f(0.2126390 * r + 0.7151687 * g + 0.0721923 * b);
  const double z = f((0.0193308 * r + 0.1191948 * g + 0.9505322 * b) / 1.0890578);
  const double l = 116 * y - 16;
  return {l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)};
}

double distance(const Lab& p, const Lab& q) {
  return std::abs(p.l - q.l) + std::hypot(p.a - q.a, p.b - q.b);
}

// Of two plain pictures in linear sRGB, in which there are no features: the paper's section 4.1.3 by hand.
double plain_flip(const Lab& p, const Lab& q) {
  const double greatest = std::pow(distance(hunt(0, 1, 0), hunt(0, 0, 1)), 0.7);
  const double power = std::pow(distance(p, q), 0.7), limit = 0.4 * greatest;
  return power < limit ? 0.95 * power / limit : 0.95 + 0.05 * (power - limit) / (greatest - limit);
}

double linear(int level) {
  const double c = level / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double measured_flip(const Raster& a, const Raster& b) {
  return *measure(a, b).flip;
}

Raster plain(int r, int g, int b) {
  return drawn(24, 20, [=](int, int) { return std::array{r, g, b}; });
}

}  // namespace

TEST_CASE("FLIP of plain pictures is the distance of their colours") {
  CHECK(measured_flip(plain(0, 0, 0), plain(255, 255, 255)) ==
        Approx(plain_flip(hunt(0, 0, 0), hunt(1, 1, 1))).margin(1e-5));
  CHECK(measured_flip(plain(0, 255, 0), plain(0, 0, 255)) == Approx(1).margin(1e-5));
  CHECK(measured_flip(plain(100, 150, 200), plain(110, 140, 190)) ==
        Approx(plain_flip(hunt(linear(100), linear(150), linear(200)),
                          hunt(linear(110), linear(140), linear(190))))
            .margin(3e-5));
  CHECK(measured_flip(plain(3, 3, 3), plain(7, 3, 3)) ==
        Approx(plain_flip(hunt(linear(3), linear(3), linear(3)), hunt(linear(7), linear(3), linear(3))))
            .margin(1e-5));
}

TEST_CASE("FLIP of black and white as the paper's constants have it") {
  // HyAB 100; 100^0.7 = 25.119 lies over 0.4 of the greatest, 41.276.
  CHECK(measured_flip(plain(0, 0, 0), plain(255, 255, 255)) == Approx(0.96738).margin(1e-4));
}

TEST_CASE("FLIP is 0 for equal pictures, at most 1, and the same both ways") {
  const Raster a = noise(60, 50, 1), b = noise(60, 50, 2);
  CHECK(measured_flip(a, a) == 0);
  CHECK(measured_flip(a, b) == measured_flip(b, a));
  CHECK(measured_flip(a, b) > 0);
  CHECK(measured_flip(a, b) < 1);
}

TEST_CASE("FLIP raises a difference that has edges over one that has none") {
  // The same share of the picture is lighter, once in one half, once in stripes.
  const Raster dark = uniform(64, 64, 3, 100);
  const Raster half = drawn(64, 64, [](int x, int) {
    return x < 32 ? std::array{130, 130, 130} : std::array{100, 100, 100};
  });
  const Raster stripes = drawn(64, 64, [](int x, int) {
    return x / 4 % 2 ? std::array{130, 130, 130} : std::array{100, 100, 100};
  });
  CHECK(measured_flip(dark, stripes) > measured_flip(dark, half));
}

TEST_CASE("FLIP looks only at tiles that differ and finds the same") {
  const Raster a = noise(300, 150, 3);
  Raster b = a;
  for (int i = 0; i < 8; ++i) set(b, 126 + i, 60, i % 3, 0), set(b, 5, 127 + i, i % 3, 255);
  const std::vector<float> everywhere(300 * 150, 1.0F);
  CHECK(measured_flip(a, b) > 0);
  Flip whole(a, b, everywhere);
  CHECK(whole.parts() == 6);
  Flip::Scratch scratch;
  for (std::size_t part = 0; part < whole.parts(); ++part) whole.measure_part(part, scratch);
  CHECK(measured_flip(a, b) == Approx(whole.mean()).margin(1e-12));
}

TEST_CASE("FLIP of gray pictures is that of three equal channels") {
  const Raster a = noise(40, 30, 1), b = noise(40, 30, 2);
  Raster gray_a{40, 30, 1, SampleType::uint8, {}}, gray_b = gray_a, rgb_a = a, rgb_b = b;
  for (std::size_t i = 0; i < a.samples.size(); i += 3) {
    gray_a.samples.push_back(a.samples[i]);
    gray_b.samples.push_back(b.samples[i]);
    rgb_a.samples[i + 1] = rgb_a.samples[i + 2] = a.samples[i];
    rgb_b.samples[i + 1] = rgb_b.samples[i + 2] = b.samples[i];
  }
  CHECK(measured_flip(gray_a, gray_b) == measured_flip(rgb_a, rgb_b));
}

TEST_CASE("FLIP takes floating-point pictures clamped to what a screen shows") {
  CHECK(measured_flip(floats(1, 1, 3, {-5, -5, -5}), floats(1, 1, 3, {9, 9, 9})) ==
        Approx(measured_flip(plain(0, 0, 0), plain(255, 255, 255))).margin(1e-6));
}

TEST_CASE("FLIP of one pixel and of a single row") {
  CHECK(measured_flip(uniform(1, 1, 3, 0), uniform(1, 1, 3, 255)) == Approx(0.96738).margin(1e-4));
  CHECK(measured_flip(uniform(200, 1, 3, 0), uniform(200, 1, 3, 255)) == Approx(0.96738).margin(1e-4));
}

TEST_CASE("FLIP agrees with its authors' program") {
  if (!std::filesystem::exists(shared / "reference/flip_truth.tsv")) {
    WARN("skipped: the pictures are not at ../shared");
    return;
  }
  const auto rows = read_table(shared / "reference/flip_truth.tsv");
  CHECK(rows.size() == 10);
  for (const auto& row : rows) {
    INFO(row[0] << " " << row[1]);
    const double flip = measured_flip(read_raster(shared / row[0]), read_raster(shared / row[1]));
    CHECK(std::abs(flip - std::stod(row[2])) < 0.0005);
  }
}
