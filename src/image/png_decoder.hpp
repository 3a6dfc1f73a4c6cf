// libpng's reading half, shared by the readers for textures (png_read.cpp) and for measuring
// (png_raster.cpp).
//
// libpng reports an error by longjmp, which must not pass over a C++ destructor. Therefore the functions that
// call setjmp and those that libpng calls back have only trivial local variables; what needs destroying lives
// outside of them.
#pragma once

#include <png.h>

#include <cstdint>
#include <cstdio>

#include "image/input_file.hpp"

namespace trace {

class PngDecoder {
 public:
  explicit PngDecoder(InputFile& file);
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder();

  // The size is known and allowed afterwards. Throws ImageError for a damaged file and for a small file that
  // claims a large picture, which must not make us allocate that only to find that most of it is missing.
  void read_header();

  std::int64_t width() const;
  std::int64_t height() const;

  // To 8-bit RGB as a screen of gamma 2.2 shows it (png.hpp). Either of these comes after read_header and is
  // followed by read_pixels.
  void ask_for_rgb8();
  // To all that is stored: palette and fewer than 8 bits expanded to 8, a tRNS chunk to alpha, 16 bits in
  // this machine's order; no gamma.
  void ask_for_all();

  // Of the converted pixels.
  int channels() const { return channels_; }
  int bits() const { return bits_; }
  std::size_t row_bytes() const { return row_bytes_; }

  // height() rows of row_bytes() each. Throws ImageError.
  void read_pixels(std::uint8_t* pixels);

 private:
  enum class Conversion { rgb8, all };
  static void on_error(png_structp png, png_const_charp text);
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep bytes, std::size_t count);
  // Each returns false after an error, which error_ tells.
  bool try_header();
  bool try_conversion(Conversion conversion);
  bool try_pixels(std::uint8_t* pixels);
  [[noreturn]] void fail() const;

  std::FILE* stream_;
  std::uint64_t file_size_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::uint64_t stored_row_bytes_ = 0;  // before the conversion
  std::size_t row_bytes_ = 0;
  int channels_ = 0;
  int bits_ = 0;
  int passes_ = 1;
  bool ended_early_ = false;
  char error_[128] = "out of memory";
};

}  // namespace trace
