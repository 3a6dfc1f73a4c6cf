#include "report/html_picture_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "image/format.hpp"
#include "image/image.hpp"
#include "image/input_file.hpp"
#include "image/png.hpp"

namespace trace::html {
namespace {

std::string kind(InputFile& file, const std::filesystem::path& path) {
  const auto format = format_of_content(file.first(magic_length), path.extension().string());
  return format ? std::string(format->name) : "";
}

// FNV-1a with 64 bits (Fowler, Noll, Vo; draft-eastlake-fnv), and the length.
struct Hash {
  std::uint64_t value = 0xcbf29ce484222325u;
  std::uint64_t size = 0;

  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) value = (value ^ byte) * 0x100000001b3u;
    size += bytes.size();
  }
  std::string text() const { return fmt::format("{:016x}-{}", value, size); }
};

}  // namespace

std::vector<std::uint8_t> png_bytes(const std::filesystem::path& file) {
  InputFile input(file);
  if (kind(input, file) != "PNG") return encode_png(read_image(file));
  std::vector<std::uint8_t> bytes(input.size());
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), input.stream()));
  return bytes;
}

bool shown_by_browsers(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 4> shown{"PNG", "JPEG", "BMP", "GIF"};
  try {
    InputFile input(file);
    return std::find(shown.begin(), shown.end(), kind(input, file)) != shown.end();
  } catch (const ImageError&) {
    return false;
  }
}

std::string fingerprint(const std::filesystem::path& file) {
  InputFile input(file);
  std::array<std::uint8_t, 65536> buffer{};
  Hash hash;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), input.stream()))
    hash.add(std::span(buffer).first(count));
  return hash.text();
}

std::string fingerprint(std::span<const std::uint8_t> bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.text();
}

}  // namespace trace::html
