// Files of a test's own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace trace::test {

// A new folder that is removed with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  std::vector<std::string> names() const;  // what is in it, in alphabetical order

 private:
  std::filesystem::path path_;
};

// Both throw where the file cannot be read or written.
std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace trace::test
