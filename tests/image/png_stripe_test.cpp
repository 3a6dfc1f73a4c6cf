#include "image/png_stripe.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace trace;

TEST_CASE("a stripe's bytes do not depend on how large the packer was made") {
  std::mt19937 random(1);
  // Noise, which has a symbol a byte, and rows alike but for noise here and there.
  for (const unsigned every : {1u, 7u, 1000u}) {
    // Around each power of two that zlib's tables may have, and the largest stripe.
    for (const int width :
         {1, 2, 20, 21, 41, 42, 84, 85, 169, 170, 171, 340, 341, 682, 683, 1365, 2730, 5461, 10922, 21845}) {
      Image image{width, 2, {}};
      image.rgb.resize(6 * static_cast<std::size_t>(width));
      for (auto& value : image.rgb) value = random() % every == 0 ? static_cast<std::uint8_t>(random()) : 50;
      for (const int rows : {1, 2}) {
        const std::size_t bytes = (3 * static_cast<std::size_t>(width) + 1) * static_cast<std::size_t>(rows);
        StripePacker exact(bytes), large(std::size_t{1} << 20);
        CHECK(exact.pack(image, 0, rows).bytes == large.pack(image, 0, rows).bytes);
      }
    }
  }
}
