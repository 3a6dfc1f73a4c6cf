#include "image/start_over.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include "image/program_places.hpp"

namespace trace {

void start_over_dynamically() {
  // As the kernel keeps them: each argument with a zero behind it.
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string arguments{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (arguments.empty() || arguments.back() != '\0') return;
  std::vector<char*> pointers;
  for (std::size_t at = 0; at < arguments.size(); at = arguments.find('\0', at) + 1)
    pointers.push_back(&arguments[at]);
  pointers.push_back(nullptr);
  for (const std::filesystem::path& place : places_beside_program(dynamic_program_name))
    execv(place.c_str(), pointers.data());
}

bool can_be_read_again(std::initializer_list<std::string_view> files) {
  for (const std::string_view file : files) {
    if (file == "-") return false;
    if (file.empty()) continue;
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return false;
  }
  return true;
}

}  // namespace trace
