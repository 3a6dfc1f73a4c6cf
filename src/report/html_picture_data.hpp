// A picture file as the report holds it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace trace::html {

// The bytes of the file if it is a PNG, else those of a PNG of the same picture in 8-bit RGB. A damaged PNG
// is given as it is: browsers show what there is of it. Throws ImageError.
std::vector<std::uint8_t> png_bytes(const std::filesystem::path& file);

// Can browsers show this kind of file? False also where it cannot be opened.
bool shown_by_browsers(const std::filesystem::path& file);

// Tells files with different bytes apart, except by an unlikely accident; the same for the same bytes. Throws
// ImageError.
std::string fingerprint(const std::filesystem::path& file);
std::string fingerprint(std::span<const std::uint8_t> bytes);

}  // namespace trace::html
