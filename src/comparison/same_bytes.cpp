#include "comparison/same_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "image/image.hpp"
#include "image/input_file.hpp"

namespace trace {

bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b) {
  if (a.extension() != b.extension()) return false;
  try {
    InputFile first(a), second(b);
    if (first.size() != second.size()) return false;
    std::array<char, 1 << 16> from_first, from_second;
    while (true) {
      const std::size_t count = std::fread(from_first.data(), 1, from_first.size(), first.stream());
      if (std::fread(from_second.data(), 1, from_second.size(), second.stream()) != count) return false;
      if (!std::equal(from_first.begin(), from_first.begin() + static_cast<std::ptrdiff_t>(count),
                      from_second.begin()))
        return false;
      if (count < from_first.size())
        return std::ferror(first.stream()) == 0 && std::ferror(second.stream()) == 0;
    }
  } catch (const ImageError&) {
    return false;
  }
}

}  // namespace trace
