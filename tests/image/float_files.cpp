#include "float_files.hpp"

#include <bit>

namespace trace::test {
namespace {

Bytes text(std::string_view characters) {  // with the zero at its end
  Bytes bytes(characters.begin(), characters.end());
  bytes.push_back(0);
  return bytes;
}

Bytes number(int value) {
  return little_endian(static_cast<std::uint32_t>(value));
}
Bytes number(float value) {
  return little_endian(std::bit_cast<std::uint32_t>(value));
}

Bytes attribute(std::string_view name, std::string_view type, const Bytes& value) {
  return text(name) + text(type) + number(static_cast<int>(value.size())) + value;
}

Bytes header(int width, int height, const std::vector<std::string>& channels) {
  Bytes list;
  for (const std::string& channel : channels)
    list = list + text(channel) + number(2) + Bytes{0, 0, 0, 0} + number(1) + number(1);  // 2: 32-bit floats
  list.push_back(0);
  const Bytes window = number(0) + number(0) + number(width - 1) + number(height - 1);
  return Bytes{0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0} + attribute("channels", "chlist", list) +
         attribute("compression", "compression", {0}) + attribute("dataWindow", "box2i", window) +
         attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", {0}) +
         attribute("pixelAspectRatio", "float", number(1.0F)) +
         attribute("screenWindowCenter", "v2f", number(0.0F) + number(0.0F)) +
         attribute("screenWindowWidth", "float", number(1.0F)) + Bytes{0};
}

}  // namespace

Bytes exr_file(int width, int height, const std::vector<std::string>& channels,
               const std::vector<float>& samples) {
  const std::size_t columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  Bytes file = header(width, height, channels);
  const std::size_t row_bytes = 4 * columns * channels.size();
  const std::size_t first_row = file.size() + 8 * rows;
  for (std::size_t y = 0; y < rows; ++y)
    file = file + number(static_cast<int>(first_row + y * (8 + row_bytes))) + number(0);
  for (std::size_t y = 0; y < rows; ++y) {
    file = file + number(static_cast<int>(y)) + number(static_cast<int>(row_bytes));
    for (std::size_t channel = 0; channel < channels.size(); ++channel)
      for (std::size_t x = 0; x < columns; ++x)
        file = file + number(samples[(y * columns + x) * channels.size() + channel]);
  }
  return file;
}

}  // namespace trace::test
