#include "tools/trace/report_info.hpp"

#include <fmt/chrono.h>

#include <ctime>

namespace trace {

std::string time_text() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

std::string title_text(const std::filesystem::path& path) {
  return std::filesystem::absolute(path / ".").lexically_normal().parent_path().filename().string();
}

}  // namespace trace
