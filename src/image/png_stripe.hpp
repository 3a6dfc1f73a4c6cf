// A PNG's pixels in stripes of rows that are compressed independently, so that threads can share them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <zlib.h>

#include "image/image.hpp"

namespace trace {

// Part of a deflate stream, and the checksums of what went in and came out.
struct PackedStripe {
  std::vector<std::uint8_t> bytes;
  std::size_t raw_size = 0;  // of the filtered rows
  uLong adler = 0;           // of the filtered rows
  uLong crc = 0;             // of `bytes`
};

// One thread's tools; used again for stripe after stripe.
class StripePacker {
 public:
  // For stripes of at most `most_bytes` after filtering. What comes out does not depend on it. Throws
  // ImageError where there is no memory.
  explicit StripePacker(std::size_t most_bytes);
  StripePacker(const StripePacker&) = delete;
  StripePacker& operator=(const StripePacker&) = delete;
  ~StripePacker();

  // Rows [first, last) of the picture. The stream ends with the last row of the picture and is otherwise left
  // at a whole byte, so that stripes one behind the other are one stream.
  PackedStripe pack(const Image& image, int first, int last);

 private:
  z_stream stream_{};
  std::vector<std::uint8_t> filtered_, packed_;
};

}  // namespace trace
