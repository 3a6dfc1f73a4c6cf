// libpng reports an error by longjmp, which must not pass over a C++ destructor. Therefore the functions that
// call setjmp and those that libpng calls back have only trivial local variables; what needs destroying lives
// outside of them.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "image/png.hpp"
#include "image/size_limits.hpp"

namespace trace {
namespace {

constexpr png_fixed_point screen_gamma = 220000;  // 2.2 in libpng's units of 1e-5

// Deflate makes data at most 1032 times smaller (zlib's technical notes).
constexpr std::uint64_t most_compression = 1032;

class Decoder {
 public:
  explicit Decoder(InputFile& file) : stream_(file.stream()) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  // Each returns false after an error, which error() tells.
  bool read_header();
  bool read_pixels(std::uint8_t* rgb);

  std::int64_t width() const { return png_get_image_width(png_, info_); }
  std::int64_t height() const { return png_get_image_height(png_, info_); }
  std::uint64_t stored_row_bytes() const { return stored_row_bytes_; }  // before the conversion to RGB
  const char* error() const { return error_; }
  bool ended_early() const { return ended_early_; }

 private:
  static void on_error(png_structp png, png_const_charp text);
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep bytes, std::size_t count);
  void ask_for_rgb8();

  std::FILE* stream_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::uint64_t stored_row_bytes_ = 0;
  bool ended_early_ = false;
  char error_[128] = "out of memory";
};

void Decoder::on_error(png_structp png, png_const_charp text) {
  auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
  std::snprintf(decoder->error_, sizeof decoder->error_, "%s", text);
  png_longjmp(png, 1);
}

void Decoder::on_read(png_structp png, png_bytep bytes, std::size_t count) {
  auto* decoder = static_cast<Decoder*>(png_get_io_ptr(png));
  if (std::fread(bytes, 1, count, decoder->stream_) == count) return;
  decoder->ended_early_ = true;
  png_error(png, "the file ends too early");
}

bool Decoder::read_header() {
  if (!info_) return false;
  if (setjmp(png_jmpbuf(png_))) return false;  // NOLINT: libpng's way
  png_set_read_fn(png_, this, on_read);
  png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size says it better
  // Chunks that must not change the pixels, and texts, which may be large.
  static constexpr png_byte skipped[] = "sRGB\0iCCP\0tEXt\0zTXt\0iTXt\0eXIf\0sPLT\0hIST";
  png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, skipped, sizeof skipped / 5);
  png_read_info(png_, info_);
  stored_row_bytes_ = png_get_rowbytes(png_, info_);
  return true;
}

void Decoder::ask_for_rgb8() {
  png_set_expand(png_);
  png_set_strip_16(png_);
  png_set_strip_alpha(png_);
  png_set_gray_to_rgb(png_);
  png_fixed_point file_gamma = 0;
  if (png_get_gAMA_fixed(png_, info_, &file_gamma)) png_set_gamma_fixed(png_, screen_gamma, file_gamma);
}

bool Decoder::read_pixels(std::uint8_t* rgb) {
  if (setjmp(png_jmpbuf(png_))) return false;  // NOLINT: libpng's way
  ask_for_rgb8();
  const int passes = png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  const std::size_t row_bytes = 3 * std::size_t(width());
  if (png_get_rowbytes(png_, info_) != row_bytes) png_error(png_, "an unexpected kind of pixels");
  for (int pass = 0; pass < passes; ++pass)
    for (std::int64_t y = 0; y < height(); ++y) png_read_row(png_, rgb + std::size_t(y) * row_bytes, nullptr);
  png_read_end(png_, nullptr);
  return true;
}

[[noreturn]] void fail(const Decoder& decoder) {
  if (decoder.ended_early()) throw ImageError("the PNG ends too early");
  throw ImageError(fmt::format("the PNG is damaged: {}", decoder.error()));
}

}  // namespace

Image read_png(InputFile& file) {
  Decoder decoder(file);
  if (!decoder.read_header()) fail(decoder);
  check_size(decoder.width(), decoder.height());
  // A small file cannot make us allocate a large picture only to find that most of it is missing.
  if (decoder.stored_row_bytes() * std::uint64_t(decoder.height()) / most_compression > file.size())
    throw ImageError("the PNG ends too early");

  Image image{int(decoder.width()), int(decoder.height()), {}};
  image.rgb.resize(std::size_t{3} * std::size_t(image.width) * std::size_t(image.height));
  if (!decoder.read_pixels(image.rgb.data())) fail(decoder);
  return image;
}

}  // namespace trace
