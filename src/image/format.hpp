// Which kind of picture file one is dealing with: told by the first bytes of a file that exists, and by the
// extension of a file to be written.
//
// To add a kind, add a line to the table in format.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace trace {

enum class Codec { png, bmp, openimageio };

struct Format {
  std::string_view name;  // as people write it: "JPEG"
  Codec codec = Codec::openimageio;
};

// How many first bytes of a file are enough for format_of_content.
inline constexpr std::size_t magic_length = 12;

// By the magic bytes; the extension (".tga", in any case) helps only for the kinds that have none.
std::optional<Format> format_of_content(std::span<const std::uint8_t> first_bytes,
                                        std::string_view extension);

// By the extension with its dot, in upper or lower case; nothing for kinds that cannot be written.
std::optional<Format> format_of_extension(std::string_view extension);

}  // namespace trace
