// Help for the tests of src/image: bytes in files, small pictures, and PNG files made chunk by
// chunk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {

using Bytes = std::vector<std::uint8_t>;

void put(const std::filesystem::path& file, const Bytes& bytes);
Bytes get(const std::filesystem::path& file);

// A picture in which no two pixels and no two channels are alike (up to 64 x 64).
Image colourful(int width, int height);

// The text of the ImageError that `action` throws; "no error" if it throws none.
template <typename Action>
std::string reason(Action action) {
  try {
    action();
  } catch (const ImageError& error) {
    return error.what();
  }
  return "no error";
}

// What reading a file with these bytes gives.
Image read_bytes(const Bytes& bytes);

// The four bytes of a number, the most or the least significant first.
Bytes big_endian(std::uint32_t value);
Bytes little_endian(std::uint32_t value, int count = 4);

Bytes operator+(Bytes left, const Bytes& right);

// A chunk of a PNG file with its length and CRC.
Bytes chunk(std::string_view type, const Bytes& data);

enum class PngColour : std::uint8_t { gray = 0, rgb = 2, palette = 3, gray_alpha = 4, rgba = 6 };

// A PNG file; `before_data` are whole chunks, `rows` the rows as stored, each with its filter byte (0: none).
Bytes png_file(std::uint32_t width, std::uint32_t height, int bits, PngColour colour,
               const Bytes& before_data, const Bytes& rows, bool interlaced = false);

}  // namespace trace::test
