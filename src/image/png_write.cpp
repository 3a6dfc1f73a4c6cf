// Writing PNG (ISO/IEC 15948): libpng packs rows one after another, so the stream is made here, of stripes.
// They are cut by the picture's size alone: the file is the same for any number of threads.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "image/png.hpp"
#include "image/png_stripe.hpp"
#include "image/size_limits.hpp"
#include "parallel/parallel.hpp"

namespace trace {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Few enough bytes to stay in the cache nearest to the processor's core from filter to checksum; many enough
// that what is lost between stripes (5 bytes and a new Huffman code) does not show.
constexpr std::size_t stripe_bytes = 64 << 10;

void put_number(Bytes& bytes, std::size_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

template <class Range>
void put(Bytes& bytes, const Range& more) {
  for (const auto byte : more) bytes.push_back(static_cast<std::uint8_t>(byte));
}

void put_chunk(Bytes& bytes, std::string_view type, const Bytes& data) {
  put_number(bytes, data.size());
  const std::size_t begin = bytes.size();
  put(bytes, type);
  put(bytes, data);
  put_number(bytes, crc32(0, &bytes[begin], static_cast<uInt>(bytes.size() - begin)));
}

Bytes header(const Image& image) {
  Bytes data;
  put_number(data, static_cast<std::size_t>(image.width));
  put_number(data, static_cast<std::size_t>(image.height));
  put(data,
      std::array<std::uint8_t, 5>{8, 2, 0, 0, 0});  // 8 bits, RGB, deflate, the usual filters, not interlaced
  return data;
}

std::vector<PackedStripe> pack(const Image& image, int threads) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width) + 1;
  const int rows = static_cast<int>(std::max(std::size_t{1}, stripe_bytes / row_bytes));
  std::vector<PackedStripe> stripes(static_cast<std::size_t>((image.height + rows - 1) / rows));
  const std::size_t most_bytes = row_bytes * static_cast<std::size_t>(std::min(rows, image.height));
  // A stripe takes some 0.15 ms: two are the least that is worth a thread.
  const int most = std::max(1, std::min(threads, static_cast<int>(stripes.size()) / 2));
  parallel_for_with(
      most, stripes.size(), [&](int) { return StripePacker(most_bytes); },
      [&](std::size_t i, StripePacker& packer) {
        const int first = static_cast<int>(i) * rows;
        stripes[i] = packer.pack(image, first, std::min(first + rows, image.height));
      });
  return stripes;
}

// One IDAT chunk: zlib's header, the stripes, the checksum of all rows.
void put_pixels(Bytes& bytes, const std::vector<PackedStripe>& stripes) {
  constexpr std::array<std::uint8_t, 2> zlib_header{0x78, 0x01};
  std::size_t size = zlib_header.size() + 4;
  uLong adler = adler32(0, nullptr, 0);
  for (const PackedStripe& stripe : stripes) {
    size += stripe.bytes.size();
    adler = adler32_combine(adler, stripe.adler, static_cast<z_off_t>(stripe.raw_size));
  }
  bytes.reserve(bytes.size() + size + 64);
  put_number(bytes, size);
  std::size_t begin = bytes.size();
  put(bytes, std::string_view("IDAT"));
  put(bytes, zlib_header);
  uLong crc = crc32(0, &bytes[begin], static_cast<uInt>(bytes.size() - begin));
  for (const PackedStripe& stripe : stripes) {
    bytes.insert(bytes.end(), stripe.bytes.begin(), stripe.bytes.end());
    crc = crc32_combine(crc, stripe.crc, static_cast<z_off_t>(stripe.bytes.size()));
  }
  begin = bytes.size();
  put_number(bytes, adler);
  put_number(bytes, crc32(crc, &bytes[begin], 4));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, int threads) {
  check_image(image);
  const std::vector<PackedStripe> stripes = pack(image, threads);
  Bytes bytes;
  put(bytes, std::array<std::uint8_t, 8>{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
  put_chunk(bytes, "IHDR", header(image));
  put_pixels(bytes, stripes);
  put_chunk(bytes, "IEND", {});
  return bytes;
}

}  // namespace trace
