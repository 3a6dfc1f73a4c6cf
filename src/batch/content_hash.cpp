#include "batch/content_hash.hpp"

#include <fmt/format.h>
#include <array>

#include "image/image_source.hpp"
#include "image/input_file.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace trace {
namespace {

std::string digits(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string content_hash(std::string_view bytes) {
  return digits(XXH3_128bits(bytes.data(), bytes.size()));
}

std::optional<std::string> file_hash(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    std::string names;
    for (const auto& entry : FileImages().list(file, error)) names += entry.filename().string() + '\0';
    return error ? std::nullopt : std::optional(content_hash(names));
  }
  try {
    const InputFile input(file);
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                                XXH3_freeState);
    if (!state) return std::nullopt;
    XXH3_128bits_reset(state.get());
    std::array<char, 1 << 16> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), input.stream()))
      XXH3_128bits_update(state.get(), buffer.data(), count);
    if (std::ferror(input.stream())) return std::nullopt;
    return digits(XXH3_128bits_digest(state.get()));
  } catch (const ImageError&) {
    return std::nullopt;
  }
}

const std::optional<std::string>& FileHashes::of(const std::filesystem::path& file) {
  const auto [entry, is_new] = known_.try_emplace(file);
  if (is_new) entry->second = file_hash(file);
  return entry->second;
}

}  // namespace trace
