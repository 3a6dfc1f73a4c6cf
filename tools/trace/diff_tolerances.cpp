#include "tools/trace/diff_tolerances.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace trace {

namespace fs = std::filesystem;

DiffTolerances::DiffTolerances(const DiffArguments& arguments, const std::string& folder,
                               const std::vector<std::string_view>& scenes)
    : fixed_(arguments.tolerance) {
  if (fixed_) return;
  path_ = arguments.tolerances;
  if (path_.empty() && !folder.empty()) path_ = (fs::path(folder) / tolerance_file_name).string();
  if (path_.empty()) return;
  // A file that the user names must be there, unless it is to be written.
  std::error_code ignored;
  if ((arguments.tolerances.empty() || arguments.update) && !fs::exists(path_, ignored)) return;

  std::optional<parser::Source> source;
  try {
    source = parser::Source::from_file(path_);
  } catch (const std::runtime_error& e) {
    valid_ = false;
    messages_ = fmt::format("trace: error: {}\n", e.what());
    return;
  }
  parser::Diagnostics diagnostics;
  std::optional<ToleranceFile> file = read_tolerances(*source, diagnostics);
  valid_ = file.has_value();
  if (file) {
    file_ = std::move(*file);
    if (!folder.empty()) warn_of_unused(file_, scenes, diagnostics);
  }
  text_ = source->text();
  messages_ = parser::render(*source, diagnostics);
}

Tolerance DiffTolerances::of(std::string_view scene) const {
  return fixed_ ? *fixed_ : file_.tolerance(scene);
}

}  // namespace trace
