// Errors of pictures of colours, and pictures enlarged.
#include "study/picture_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace trace::test {
namespace {

ColorImage constant(int width, int height, const Rgb& color) {
  ColorImage picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture.set(x, y, color);
  }
  return picture;
}

// Its value at a place of the picture, (0, 0) lower left to (1, 1).
double ramp_at(double x, double y) {
  return 0.1 + 0.5 * x + 0.25 * y;
}

// Each pixel the sample at its lower left corner.
ColorImage ramp(int width, int height) {
  ColorImage picture(width, height);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i)
      picture.set(i, height - 1 - j,
                  Rgb(ramp_at(static_cast<double>(i) / width, static_cast<double>(j) / height)));
  }
  return picture;
}

}  // namespace

TEST_CASE("a picture is not off itself") {
  const PictureError none = picture_error(ramp(7, 5), ramp(7, 5));
  CHECK(none.root_mean_square == 0);
  CHECK(none.mean_absolute == 0);
  CHECK(none.largest == 0);
}

TEST_CASE("errors are in levels over all channels of all pixels, either way") {
  const ColorImage truth = constant(2, 2, {0.5, 0.5, 0.5});
  ColorImage picture = truth;
  picture.set(0, 0, {0.75, 0.5, 0.5});
  picture.set(1, 1, {0.5, 0.5, 0.375});
  const PictureError error = picture_error(picture, truth), back = picture_error(truth, picture);
  CHECK(error.largest == 255 * 0.25);
  CHECK(error.mean_absolute == Approx(255 * 0.375 / 12));
  CHECK(error.root_mean_square == Approx(255 * std::sqrt((0.0625 + 0.015625) / 12)));
  CHECK(back.root_mean_square == error.root_mean_square);
  CHECK(back.largest == error.largest);
}

TEST_CASE("the mean of two pictures lies between them") {
  const ColorImage middle = mean(constant(3, 2, {0, 0.5, 1}), constant(3, 2, {1, 0.5, 0.5}));
  REQUIRE(middle.width() == 3);
  REQUIRE(middle.height() == 2);
  CHECK(middle.at(0, 0) == Rgb(0.5, 0.5, 0.75));
  CHECK(middle.at(2, 1) == Rgb(0.5, 0.5, 0.75));
}

TEST_CASE("a constant picture stays constant however it is enlarged") {
  const Rgb color(0.25, 0.5, 0.75);
  for (const auto& [width, height] : {std::pair{8, 6}, {4, 3}, {5, 7}, {64, 1}}) {
    const ColorImage large = enlarged(constant(4, 3, color), width, height);
    REQUIRE(large.width() == width);
    REQUIRE(large.height() == height);
    int wrong = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) wrong += large.at(x, y) != color;
    }
    CHECK(wrong == 0);
  }
  CHECK(enlarged(constant(1, 1, color), 3, 3).at(2, 0) == color);
}

TEST_CASE("a linear ramp stays linear where there are samples all around, and goes on as it is beyond") {
  const int w = 6, h = 4;
  for (const int times : {2, 4, 5}) {
    const ColorImage large = enlarged(ramp(w, h), w * times, h * times);
    double inside = 0, beyond = 0;
    for (int j = 0; j < h * times; ++j) {
      for (int i = 0; i < w * times; ++i) {
        const double x = (i + 0.5) / (w * times), y = (j + 0.5) / (h * times);
        const double last_x = 1 - 1.0 / w, last_y = 1 - 1.0 / h;
        const double found = large.at(i, h * times - 1 - j).x;
        const double off = std::abs(found - ramp_at(std::min(x, last_x), std::min(y, last_y)));
        double& largest = x <= last_x && y <= last_y ? inside : beyond;
        largest = std::max(largest, off);
      }
    }
    INFO(times << " times as large");
    CHECK(inside < 1e-6);
    CHECK(beyond < 1e-6);
  }
}

}  // namespace trace::test
