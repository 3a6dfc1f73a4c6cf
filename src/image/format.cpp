#include "image/format.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace trace {
namespace {

using namespace std::string_view_literals;

struct Kind {
  Format format;
  std::array<std::string_view, 3> extensions;  // to write by; the unused ones are empty
  std::array<std::string_view, 3> magic;       // '?' stands for any byte; the unused ones are empty
};

constexpr auto kinds = std::to_array<Kind>({
    {{"PNG", Codec::png}, {".png"}, {"\x89PNG\r\n\x1a\n"}},
    {{"BMP", Codec::bmp}, {".bmp"}, {"BM"}},
    {{"JPEG"}, {".jpg", ".jpeg", ".jpe"}, {"\xff\xd8\xff"}},
    {{"TIFF"}, {".tif", ".tiff"}, {"II*\0"sv, "MM\0*"sv, "II+\0"sv}},
    {{"OpenEXR"}, {".exr"}, {"v/1\x01"}},
    {{"Radiance HDR"}, {".hdr", ".rgbe"}, {"#?RADIANCE", "#?RGBE"}},
    {{"GIF"}, {".gif"}, {"GIF8"}},
    {{"WebP"}, {".webp"}, {"RIFF\?\?\?\?WEBP"}},
    {{"JPEG 2000"}, {}, {"\0\0\0\x0cjP  "sv, "\xff\x4f\xff\x51"}},
    {{"HEIF"}, {".heic", ".heif"}, {"\?\?\?\?ftyp"}},
    {{"PNM"}, {".ppm", ".pnm"}, {}},
    {{"PFM"}, {}, {"PF\n", "Pf\n"}},
    {{"DPX"}, {".dpx"}, {"SDPX", "XPDS"}},
    {{"SGI"}, {".sgi", ".rgb", ".bw"}, {"\x01\xda"}},
    {{"DDS"}, {}, {"DDS "}},
    {{"Photoshop"}, {}, {"8BPS"}},
    {{"icon"}, {".ico"}, {"\0\0\x01\0"sv}},
    {{"TARGA"}, {".tga"}, {}},
});

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return lower;
}

bool starts_with(std::span<const std::uint8_t> bytes, std::string_view magic) {
  return !magic.empty() && bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char m, std::uint8_t b) { return m == '?' || std::uint8_t(m) == b; });
}

// "P1" to "P6" and then white space.
bool is_pnm(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
         (bytes[2] == ' ' || (bytes[2] >= '\t' && bytes[2] <= '\r'));
}

}  // namespace

std::optional<Format> format_of_content(std::span<const std::uint8_t> first_bytes,
                                        std::string_view extension) {
  for (const Kind& kind : kinds)
    for (std::string_view magic : kind.magic)
      if (starts_with(first_bytes, magic)) return kind.format;
  if (is_pnm(first_bytes)) return Format{"PNM"};
  if (lower_case(extension) == ".tga") return Format{"TARGA"};
  return {};
}

std::optional<Format> format_of_extension(std::string_view extension) {
  if (extension.empty()) return {};
  const std::string wanted = lower_case(extension);
  for (const Kind& kind : kinds)
    if (std::ranges::find(kind.extensions, wanted) != kind.extensions.end()) return kind.format;
  return {};
}

}  // namespace trace
