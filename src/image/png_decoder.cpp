#include "image/png_decoder.hpp"

#include <fmt/format.h>

#include <bit>

#include "image/image.hpp"
#include "image/size_limits.hpp"

namespace trace {
namespace {

constexpr png_fixed_point screen_gamma = 220000;  // 2.2 in libpng's units of 1e-5

// Deflate makes data at most 1032 times smaller (zlib's technical notes).
constexpr std::uint64_t most_compression = 1032;

}  // namespace

PngDecoder::PngDecoder(InputFile& file) : stream_(file.stream()), file_size_(file.size()) {
  png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
  info_ = png_ ? png_create_info_struct(png_) : nullptr;
}

PngDecoder::~PngDecoder() {
  png_destroy_read_struct(&png_, &info_, nullptr);
}

void PngDecoder::on_error(png_structp png, png_const_charp text) {
  auto* decoder = static_cast<PngDecoder*>(png_get_error_ptr(png));
  std::snprintf(decoder->error_, sizeof decoder->error_, "%s", text);
  png_longjmp(png, 1);
}

void PngDecoder::on_read(png_structp png, png_bytep bytes, std::size_t count) {
  auto* decoder = static_cast<PngDecoder*>(png_get_io_ptr(png));
  if (std::fread(bytes, 1, count, decoder->stream_) == count) return;
  decoder->ended_early_ = true;
  png_error(png, "the file ends too early");
}

void PngDecoder::fail() const {
  if (ended_early_) throw ImageError("the PNG ends too early");
  throw ImageError(fmt::format("the PNG is damaged: {}", error_));
}

std::int64_t PngDecoder::width() const {
  return png_get_image_width(png_, info_);
}

std::int64_t PngDecoder::height() const {
  return png_get_image_height(png_, info_);
}

bool PngDecoder::try_header() {
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

void PngDecoder::read_header() {
  if (!try_header()) fail();
  check_size(width(), height());
  if (stored_row_bytes_ * std::uint64_t(height()) / most_compression > file_size_)
    throw ImageError("the PNG ends too early");
}

bool PngDecoder::try_conversion(Conversion conversion) {
  if (setjmp(png_jmpbuf(png_))) return false;  // NOLINT: libpng's way
  png_set_expand(png_);
  if (conversion == Conversion::rgb8) {
    png_set_strip_16(png_);
    png_set_strip_alpha(png_);
    png_set_gray_to_rgb(png_);
    png_fixed_point file_gamma = 0;
    if (png_get_gAMA_fixed(png_, info_, &file_gamma)) png_set_gamma_fixed(png_, screen_gamma, file_gamma);
  } else if (std::endian::native == std::endian::little) {
    png_set_swap(png_);
  }
  passes_ = png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  channels_ = png_get_channels(png_, info_);
  bits_ = png_get_bit_depth(png_, info_);
  row_bytes_ = png_get_rowbytes(png_, info_);
  const std::size_t expected = std::size_t(width()) * std::size_t(channels_) * std::size_t(bits_ / 8);
  const bool usual = conversion == Conversion::rgb8 ? channels_ == 3 && bits_ == 8 : bits_ >= 8;
  if (!usual || row_bytes_ != expected) png_error(png_, "an unexpected kind of pixels");
  return true;
}

void PngDecoder::ask_for_rgb8() {
  if (!try_conversion(Conversion::rgb8)) fail();
}

void PngDecoder::ask_for_all() {
  if (!try_conversion(Conversion::all)) fail();
}

bool PngDecoder::try_pixels(std::uint8_t* pixels) {
  if (setjmp(png_jmpbuf(png_))) return false;  // NOLINT: libpng's way
  for (int pass = 0; pass < passes_; ++pass)
    for (std::int64_t y = 0; y < height(); ++y)
      png_read_row(png_, pixels + std::size_t(y) * row_bytes_, nullptr);
  png_read_end(png_, nullptr);
  return true;
}

void PngDecoder::read_pixels(std::uint8_t* pixels) {
  if (!try_pixels(pixels)) fail();
}

}  // namespace trace
