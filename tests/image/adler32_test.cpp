#include "image/adler32.hpp"

#include <zlib.h>

#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace trace;

TEST_CASE("the checksum Adler-32 is zlib's, for any length and for the largest sums") {
  std::mt19937 random(2);
  for (const std::size_t size : {0, 1, 15, 16, 17, 31, 33, 1000, 65535, 65536, 65537, 65552, 200003}) {
    std::vector<std::uint8_t> bytes(size, 255);
    CHECK(adler32_of(bytes) == adler32(1, bytes.data(), static_cast<uInt>(size)));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    CHECK(adler32_of(bytes) == adler32(1, bytes.data(), static_cast<uInt>(size)));
  }
}
