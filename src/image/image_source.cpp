#include "image/image_source.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>

#include "image/input_file.hpp"
#include "image/system_error.hpp"

namespace trace {

std::vector<std::filesystem::path> ImageSource::list(const std::filesystem::path& folder,
                                                     std::error_code& error) {
  std::vector<std::filesystem::path> found;
  std::filesystem::directory_iterator entry(folder, error);
  for (const std::filesystem::directory_iterator end; !error && entry != end; entry.increment(error))
    found.push_back(entry->path());
  std::sort(found.begin(), found.end());
  return found;
}

std::string ImageSource::bytes(const std::filesystem::path& file, std::uint64_t limit) {
  const InputFile input(file);
  if (input.size() > limit) {
    throw ImageError("it has " + std::to_string(input.size()) + " bytes, more than " + std::to_string(limit));
  }
  std::string result(input.size(), '\0');
  result.resize(std::fread(result.data(), 1, result.size(), input.stream()));
  if (std::ferror(input.stream())) throw ImageError(system_reason(errno));
  return result;
}

SharedImage FileImages::read(const std::filesystem::path& file) {
  const auto begin = std::chrono::steady_clock::now();
  DecodedImage decoded = decode_image(file);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  switch (decoded.codec) {
    case Codec::png:
      ++decoded_.by_libpng;
      break;
    case Codec::bmp:
      ++decoded_.by_stb;
      break;
    case Codec::openimageio:
      ++decoded_.by_openimageio;
  }
  decoded_.file_bytes += decoded.file_bytes;
  decoded_.pixel_bytes += decoded.image.rgb.size();
  decoded_.milliseconds += spent.count();
  return share(std::move(decoded.image));
}

bool FileImages::exists(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

SharedImage share(Image image) {
  const auto owner = std::make_shared<const Image>(std::move(image));
  return {owner->width, owner->height, {owner, owner->rgb.data()}};
}

}  // namespace trace
