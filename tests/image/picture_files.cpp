#include "picture_files.hpp"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace trace::test {

void put(const std::filesystem::path& file, const Bytes& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

Bytes get(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

Image colourful(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int value : {4 * x, 4 * y + 1, 255 - 3 * x - y}) image.rgb.push_back(std::uint8_t(value));
  return image;
}

Image read_bytes(const Bytes& bytes) {
  const TemporaryFolder directory;
  put(directory / "file", bytes);
  return read_image(directory / "file");
}

Bytes big_endian(std::uint32_t value) {
  return {std::uint8_t(value >> 24), std::uint8_t(value >> 16), std::uint8_t(value >> 8),
          std::uint8_t(value)};
}

Bytes little_endian(std::uint32_t value, int count) {
  Bytes bytes;
  for (int i = 0; i < count; ++i) bytes.push_back(std::uint8_t(value >> 8 * i));
  return bytes;
}

Bytes operator+(Bytes left, const Bytes& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

Bytes chunk(std::string_view type, const Bytes& data) {
  const Bytes body = Bytes(type.begin(), type.end()) + data;
  return big_endian(std::uint32_t(data.size())) + body +
         big_endian(std::uint32_t(crc32(0, body.data(), uInt(body.size()))));
}

Bytes png_file(std::uint32_t width, std::uint32_t height, int bits, PngColour colour,
               const Bytes& before_data, const Bytes& rows, bool interlaced) {
  uLongf size = compressBound(uLong(rows.size()));
  Bytes data(size);
  compress(data.data(), &size, rows.data(), uLong(rows.size()));
  data.resize(size);
  const Bytes kind{std::uint8_t(bits), std::uint8_t(colour), 0, 0, std::uint8_t(interlaced)};
  return Bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'} +
         chunk("IHDR", big_endian(width) + big_endian(height) + kind) + before_data + chunk("IDAT", data) +
         chunk("IEND", {});
}

}  // namespace trace::test
