// Where a scene's pictures come from: the file system, or whoever keeps pictures that several scenes share.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "image/image.hpp"

namespace trace {

// A decoded picture that may belong to several at once: 8-bit RGB, 3 bytes a pixel, rows from top to bottom.
struct SharedImage {
  int width = 0;
  int height = 0;
  std::shared_ptr<const std::uint8_t[]> rgb;
};

class ImageSource {
 public:
  virtual ~ImageSource() = default;

  // The picture in a file, as read_image. Throws ImageError.
  virtual SharedImage read(const std::filesystem::path& file) = 0;

  // The bytes of a file that is no picture, at most `limit` of them. Throws ImageError, of longer files too.
  virtual std::string bytes(const std::filesystem::path& file, std::uint64_t limit);

  // Whether there is such a file. Sources that keep account of what a scene depends on want to be asked.
  virtual bool exists(const std::filesystem::path& file) = 0;

  // What is in a folder, in order of the names. Empty with an error where it cannot be read.
  virtual std::vector<std::filesystem::path> list(const std::filesystem::path& folder,
                                                  std::error_code& error);
};

// Pictures that were decoded, and by whom.
struct DecodedPictures {
  std::uint64_t by_libpng = 0, by_stb = 0, by_openimageio = 0;
  std::uint64_t file_bytes = 0;   // of their files
  std::uint64_t pixel_bytes = 0;  // of what was decoded
  double milliseconds = 0;        // reading and decoding

  std::uint64_t count() const { return by_libpng + by_stb + by_openimageio; }
};

// Reads the file each time.
class FileImages : public ImageSource {
 public:
  SharedImage read(const std::filesystem::path& file) override;
  bool exists(const std::filesystem::path& file) override;

  // Those that read() has delivered.
  const DecodedPictures& decoded() const { return decoded_; }

 private:
  DecodedPictures decoded_;
};

SharedImage share(Image image);

}  // namespace trace
