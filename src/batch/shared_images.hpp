// The pictures of one job's scene: decoded once for all workers, and kept account of.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "image/image_source.hpp"
#include "process/blob_exchange.hpp"

namespace trace {

class SharedImages : public ImageSource {
 public:
  explicit SharedImages(BlobExchange& exchange) : exchange_(exchange) {}

  SharedImage read(const std::filesystem::path& file) override;
  std::string bytes(const std::filesystem::path& file, std::uint64_t limit) override;
  bool exists(const std::filesystem::path& file) override;
  std::vector<std::filesystem::path> list(const std::filesystem::path& folder,
                                          std::error_code& error) override;

  // Every file that was asked for, with the hash of its content; nothing where it could not be read.
  const std::map<std::string, std::optional<std::string>>& asked() const { return asked_; }

 private:
  BlobExchange& exchange_;
  std::map<std::string, std::optional<std::string>> asked_;
};

}  // namespace trace
