#include "image/bmp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "image/size_limits.hpp"
#include "image/stb_bmp.hpp"

namespace trace {
namespace {

constexpr std::size_t file_header_size = 14;
constexpr std::size_t largest_header = file_header_size + 124;
constexpr std::uint32_t uncompressed = 0, bit_fields = 3;

std::uint32_t little_endian(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t count) {
  if (at + count > bytes.size()) throw ImageError("the BMP ends too early");
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | bytes[at + i];
  return value;
}

// What the two headers say of a BMP file, in bytes where nothing else is said.
struct Layout {
  std::int64_t width, height;  // pixels
  std::uint32_t bits;          // a pixel
  std::uint64_t header_end;    // with the colour masks that follow some headers; the palette starts here
  std::uint64_t palette_size;  // as much as there is of it
  std::uint64_t pixels_start, row_size, pixels_size;  // rows are padded to 4 bytes
};

Layout read_layout(const std::vector<std::uint8_t>& header) {
  Layout layout{};
  layout.pixels_start = little_endian(header, 10, 4);
  const std::uint32_t info_size = little_endian(header, 14, 4);
  std::uint32_t compression = uncompressed;
  if (info_size == 12) {  // OS/2
    layout.width = little_endian(header, 18, 2);
    layout.height = little_endian(header, 20, 2);
    layout.bits = little_endian(header, 24, 2);
  } else {
    layout.width = std::int32_t(little_endian(header, 18, 4));
    layout.height = std::abs(std::int64_t{std::int32_t(little_endian(header, 22, 4))});  // < 0: from the top
    layout.bits = little_endian(header, 28, 2);
    compression = little_endian(header, 30, 4);
  }
  check_size(layout.width, layout.height);
  if (compression != uncompressed && compression != bit_fields)
    throw ImageError("a compressed BMP cannot be read");
  if (info_size == 12 && layout.bits < 16)
    throw ImageError("a BMP of OS/2 with a palette cannot be read");  // stb misreads its palette

  constexpr auto known_bits = std::to_array<std::uint32_t>({1, 4, 8, 16, 24, 32});
  if (std::ranges::find(known_bits, layout.bits) == known_bits.end())
    throw ImageError(fmt::format("a BMP of {} bits a pixel cannot be read", layout.bits));

  layout.header_end = file_header_size + info_size;
  if (compression == bit_fields && info_size == 40) layout.header_end += 12;
  if (info_size > 124 || layout.pixels_start < layout.header_end)
    throw ImageError("the BMP is damaged: bad offset");
  layout.palette_size =
      layout.bits < 16 ? std::min<std::uint64_t>(layout.pixels_start - layout.header_end, 4ULL << layout.bits)
                       : 0;

  const std::uint64_t row_bits = std::uint64_t(layout.width) * layout.bits;
  layout.row_size = (row_bits + 31) / 32 * 4;
  // The padding of the last row may be missing.
  layout.pixels_size = layout.row_size * std::uint64_t(layout.height - 1) + (row_bits + 7) / 8;
  return layout;
}

void append(InputFile& file, std::uint64_t count, std::vector<std::uint8_t>& to) {
  const std::size_t before = to.size();
  to.resize(before + count);
  if (std::fread(to.data() + before, 1, count, file.stream()) != count)
    throw ImageError("the BMP ends too early");
}

// The same picture with a full palette (black where it is short: stb would use whatever is in the memory) and
// the pixels right after it (stb refuses gaps).
std::vector<std::uint8_t> without_gaps(InputFile& file, const Layout& layout) {
  const std::uint64_t full_palette = layout.bits < 16 ? 4ULL << layout.bits : 0;
  const std::uint64_t start = layout.header_end + full_palette;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(start + layout.pixels_size);
  append(file, layout.header_end + layout.palette_size, bytes);
  bytes.resize(start);
  for (std::size_t i = 0; i < 4; ++i) bytes[10 + i] = std::uint8_t(start >> 8 * i);
  if (std::fseek(file.stream(), long(layout.pixels_start), SEEK_SET) != 0)
    throw ImageError("the BMP ends too early");
  append(file, layout.pixels_size, bytes);
  return bytes;
}

}  // namespace

Image read_bmp(InputFile& file) {
  const Layout layout = read_layout(file.first(largest_header));
  if (layout.pixels_start + layout.pixels_size > file.size()) throw ImageError("the BMP ends too early");
  return stb_decode_bmp(without_gaps(file, layout));
}

std::vector<std::uint8_t> encode_bmp(const Image& image) {
  check_image(image);
  return stb_encode_bmp(image);
}

}  // namespace trace
