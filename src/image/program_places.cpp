#include "image/program_places.hpp"

#include <system_error>

namespace trace {

std::vector<std::filesystem::path> places_beside_program(std::string_view name) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const std::filesystem::path directory = program.parent_path();
  return {directory / name, directory.parent_path() / "lib" / "trace" / name};
}

}  // namespace trace
