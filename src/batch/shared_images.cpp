#include "batch/shared_images.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstring>

#include "batch/content_hash.hpp"

namespace trace {
namespace {

// What a blob begins with; the pixels follow.
struct Header {
  std::int32_t width, height;
  char hash[32];  // of the file's content
};

// A file by this name and of this state: another one of the same size and time would have to be made within
// the clock's resolution.
std::string key_of(const std::filesystem::path& file) {
  struct stat state {};
  if (stat(file.c_str(), &state) != 0) return file.string();
  return fmt::format("{}:{}:{}:{}.{}", state.st_dev, state.st_ino, state.st_size, state.st_mtim.tv_sec,
                     state.st_mtim.tv_nsec);
}

std::vector<std::uint8_t> decode(const std::filesystem::path& file) {
  // The hash first: of a file that is replaced meanwhile it is then the old one's, and the next run sees a
  // change.
  const std::string hash = file_hash(file).value_or(std::string(sizeof(Header::hash), '?'));
  const Image image = read_image(file);
  Header header{image.width, image.height, {}};
  std::memcpy(header.hash, hash.data(), sizeof header.hash);
  std::vector<std::uint8_t> bytes(sizeof header + image.rgb.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, image.rgb.data(), image.rgb.size());
  return bytes;
}

}  // namespace

SharedImage SharedImages::read(const std::filesystem::path& file) {
  std::optional<std::string>& hash = asked_[file.string()];
  try {
    const Blob blob = exchange_.get(key_of(file), [&] { return decode(file); });
    Header header;
    std::memcpy(&header, blob.bytes.data(), sizeof header);
    hash.emplace(header.hash, sizeof header.hash);
    return {header.width, header.height, {blob.owner, blob.bytes.data() + sizeof header}};
  } catch (const ImageError&) {
    hash = file_hash(file);
    throw;
  }
}

std::string SharedImages::bytes(const std::filesystem::path& file, std::uint64_t limit) {
  asked_[file.string()] = file_hash(file);
  return ImageSource::bytes(file, limit);
}

bool SharedImages::exists(const std::filesystem::path& file) {
  std::error_code ignored;
  const bool found = std::filesystem::exists(file, ignored);
  if (!found) asked_.try_emplace(file.string());
  return found;
}

std::vector<std::filesystem::path> SharedImages::list(const std::filesystem::path& folder,
                                                      std::error_code& error) {
  asked_[folder.string()] = file_hash(folder);
  return ImageSource::list(folder, error);
}

}  // namespace trace
