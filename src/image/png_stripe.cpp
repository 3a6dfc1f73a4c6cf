#include "image/png_stripe.hpp"

#include <algorithm>

#include "image/adler32.hpp"

namespace trace {
namespace {

constexpr std::uint8_t filter_up = 2;

// Each row behind its filter's number, as differences from the row above it.
void filter_rows(const Image& image, int first, int last, std::vector<std::uint8_t>& filtered) {
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width);
  filtered.resize((row_bytes + 1) * static_cast<std::size_t>(last - first));
  std::uint8_t* to = filtered.data();
  for (int y = first; y < last; ++y) {
    const std::uint8_t* const row = image.rgb.data() + static_cast<std::size_t>(y) * row_bytes;
    *to++ = filter_up;
    if (y == 0) {
      std::copy_n(row, row_bytes, to);
    } else {
      const std::uint8_t* const above = row - row_bytes;
      for (std::size_t i = 0; i < row_bytes; ++i) to[i] = static_cast<std::uint8_t>(row[i] - above[i]);
    }
    to += row_bytes;
  }
}

// The least of zlib's parameters (deflateInit2) with which `bytes` of input become what they become with the
// largest: the window holds them all, and so does the buffer of symbols, at most one a byte, that is emptied
// as one block when all but one of its places are taken. zlib clears its hash table of 2^(memory + 8) bytes
// even where it looks for runs alone, and for a tiny picture those pages took longer than all the rest of the
// writing.
struct DeflateSize {
  int window_bits = 9;
  int memory = 1;
};

DeflateSize size_for(std::size_t bytes) {
  constexpr int most_window_bits = 15, most_memory = 9;
  DeflateSize size;
  while (size.window_bits < most_window_bits && (std::size_t{1} << size.window_bits) <= bytes)
    ++size.window_bits;
  while (size.memory < most_memory && (std::size_t{1} << (size.memory + 6)) <= bytes + 1) ++size.memory;
  return size;
}

}  // namespace

// The filter "up" turns rendered surfaces and backgrounds into runs of equal small numbers. Looking for those
// runs alone, rather than for any repeated string, takes a quarter less time on pictures textured everywhere
// and is alike on others; so are the files.
StripePacker::StripePacker(std::size_t most_bytes) {
  constexpr int level = 1;
  const DeflateSize size = size_for(most_bytes);
  if (deflateInit2(&stream_, level, Z_DEFLATED, -size.window_bits, size.memory, Z_RLE) != Z_OK)
    throw ImageError("the PNG cannot be made: out of memory");
}

StripePacker::~StripePacker() {
  deflateEnd(&stream_);
}

PackedStripe StripePacker::pack(const Image& image, int first, int last) {
  filter_rows(image, first, last, filtered_);
  deflateReset(&stream_);
  constexpr std::size_t flush_marker = 16;
  packed_.resize(deflateBound(&stream_, static_cast<uLong>(filtered_.size())) + flush_marker);
  stream_.next_in = filtered_.data();
  stream_.avail_in = static_cast<uInt>(filtered_.size());
  stream_.next_out = packed_.data();
  stream_.avail_out = static_cast<uInt>(packed_.size());
  const bool end = last == image.height;
  const int result = deflate(&stream_, end ? Z_FINISH : Z_SYNC_FLUSH);
  if (result != (end ? Z_STREAM_END : Z_OK) || stream_.avail_in != 0)
    throw ImageError("the PNG cannot be made: zlib failed");
  PackedStripe stripe;
  stripe.bytes.assign(packed_.data(), stream_.next_out);
  stripe.raw_size = filtered_.size();
  stripe.adler = adler32_of(filtered_);
  stripe.crc = crc32(0, stripe.bytes.data(), static_cast<uInt>(stripe.bytes.size()));
  return stripe;
}

}  // namespace trace
