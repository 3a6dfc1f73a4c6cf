// A file that lives in memory, for libraries that write to files only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trace {

class MemoryFile {
 public:
  MemoryFile();  // throws ImageError
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();

  std::string path() const;                 // by which this process may open it
  std::vector<std::uint8_t> bytes() const;  // what it holds now; throws ImageError

 private:
  int descriptor_;
};

}  // namespace trace
