// Whether two files are the same for every reader.
#pragma once

#include <filesystem>

namespace trace {

// True where both can be read, hold the same bytes, and have the same extension, which may tell the format.
bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace trace
