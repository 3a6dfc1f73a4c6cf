#include "rendering/pixel.hpp"

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a byte is 255 times the limited channel, truncated") {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::pair<double, int> table[] = {{0.5, 127},  {0.999, 254}, {0.0039, 0},     {0.00392157, 1},
                                          {0.0078, 1}, {1.5, 255},   {-0.5, 0},       {0, 0},
                                          {1, 255},    {-0.0, 0},    {infinity, 255}, {-infinity, 0}};
  for (const auto& [channel, byte] : table) {
    INFO(channel);
    CHECK(static_cast<int>(to_byte(clamped(channel))) == byte);
  }
}

TEST_CASE("limiting a colour leaves each channel by itself") {
  CHECK(clamped(Rgb(-1, 2, 0.25)) == Rgb(0, 1, 0.25));
}

TEST_CASE("every byte over 255 becomes itself again, but for the roundings of division") {
  int off = 0;
  for (int b = 0; b < 256; ++b) {
    const int again = to_byte(b / 255.0);
    CHECK((again == b || again == b - 1));
    if (again != b) ++off;
  }
  CHECK(off < 20);
}

TEST_CASE("row 0 of a picture's pixels is the lowest, which files hold last") {
  Image image{2, 3, std::vector<std::uint8_t>(18)};
  set_pixel(image, 1, 0, Rgb(1, 0.5, 0));
  CHECK(image.rgb[15] == 255);
  CHECK(image.rgb[16] == 127);
  CHECK(pixel(image, 1, 0)[0] == 255);
  set_pixel(image, 0, 2, Rgb(1));
  CHECK(image.rgb[0] == 255);
}
