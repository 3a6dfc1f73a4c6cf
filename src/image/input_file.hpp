// A file opened for reading, with its size known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace trace {

class InputFile {
 public:
  // Throws ImageError if there is no such file, it may not be read, or it is not a regular file (a directory
  // has no bytes; a pipe or a device could make us wait for ever).
  explicit InputFile(const std::filesystem::path& path);

  std::FILE* stream() const { return stream_.get(); }
  std::uint64_t size() const { return size_; }  // in bytes, when it was opened

  // The first `count` bytes, fewer if the file is shorter; the next read starts at the beginning again.
  std::vector<std::uint8_t> first(std::size_t count);

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::unique_ptr<std::FILE, Close> stream_;
  std::uint64_t size_ = 0;
};

}  // namespace trace
