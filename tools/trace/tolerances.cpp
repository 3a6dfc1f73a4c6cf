#include "tools/trace/tolerances.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace trace {

namespace fs = std::filesystem;

Tolerances::Tolerances(const ToleranceChoice& choice, const std::vector<std::string_view>& scenes)
    : fixed_(choice.fixed) {
  if (fixed_) return;
  path_ = choice.file;
  if (path_.empty() && !choice.folder.empty())
    path_ = (fs::path(choice.folder) / tolerance_file_name).string();
  if (path_.empty()) return;
  // A file that the user names must be there, unless it is to be written.
  std::error_code ignored;
  if ((choice.file.empty() || choice.may_be_missing) && !fs::exists(path_, ignored)) return;

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
    if (!choice.folder.empty()) warn_of_unused(file_, scenes, diagnostics);
  }
  text_ = source->text();
  messages_ = parser::render(*source, diagnostics);
}

Tolerance Tolerances::of(std::string_view scene) const {
  return fixed_ ? *fixed_ : file_.tolerance(scene);
}

}  // namespace trace
