#include "tests/commands/exr_file.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

// Numbers are little-endian.
std::string bytes(std::uint64_t value, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += static_cast<char>(value >> (8 * i));
  return result;
}
std::string whole(int value) {
  return bytes(static_cast<std::uint32_t>(value), 4);
}
std::string real(float value) {
  return bytes(std::bit_cast<std::uint32_t>(value), 4);
}
std::string text(std::string_view value) {
  return std::string(value) + '\0';
}
std::string attribute(std::string_view name, std::string_view type, const std::string& value) {
  return text(name) + text(type) + whole(static_cast<int>(value.size())) + value;
}

std::string header(int width, int height) {
  constexpr int float_type = 2;
  std::string channels;
  for (const char* name : {"B", "G", "R"})
    channels += text(name) + whole(float_type) + whole(0) + whole(1) + whole(1);
  const std::string window = whole(0) + whole(0) + whole(width - 1) + whole(height - 1);
  return whole(20000630) + whole(2) + attribute("channels", "chlist", channels + '\0') +
         attribute("compression", "compression", bytes(0, 1)) + attribute("dataWindow", "box2i", window) +
         attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", bytes(0, 1)) +
         attribute("pixelAspectRatio", "float", real(1)) +
         attribute("screenWindowCenter", "v2f", real(0) + real(0)) +
         attribute("screenWindowWidth", "float", real(1)) + '\0';
}

}  // namespace

void write_exr(const std::filesystem::path& file, int width, int height, const std::vector<float>& samples) {
  const std::string head = header(width, height);
  const int row_bytes = width * 3 * 4;
  std::string offsets, rows;
  for (int y = 0; y < height; ++y) {
    offsets += bytes(head.size() + static_cast<std::size_t>(height) * 8 + rows.size(), 8);
    rows += whole(y) + whole(row_bytes);
    for (int channel : {2, 1, 0})
      for (int x = 0; x < width; ++x)
        rows += real(samples[static_cast<std::size_t>((y * width + x) * 3 + channel)]);
  }
  write_text(file, head + offsets + rows);
}

}  // namespace trace::test
