// What a file holds, as a short text: two files with the same hash are taken to be the same. It tells an
// edited file from an untouched one; it is no protection against forgery.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace trace {

// XXH3 with 128 bits, as 32 hexadecimal digits.
std::string content_hash(std::string_view bytes);

// Of a folder: the names in it. Nothing where the file is not there or cannot be read.
std::optional<std::string> file_hash(const std::filesystem::path& file);

// Hashes files once each; for a moment in which none of them changes.
class FileHashes {
 public:
  const std::optional<std::string>& of(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, std::optional<std::string>> known_;
};

}  // namespace trace
