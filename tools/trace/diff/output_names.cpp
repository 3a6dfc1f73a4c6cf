#include "tools/trace/diff/output_names.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace trace {
namespace {

namespace fs = std::filesystem;

struct Output {
  std::string_view what;
  fs::path file, resolved;
};

fs::path resolved(const fs::path& file) {
  std::error_code failed;
  fs::path absolute = fs::absolute(file, failed);
  if (failed) absolute = file;
  const fs::path canonical = fs::weakly_canonical(absolute, failed);
  return failed ? absolute.lexically_normal() : canonical;
}

// By name too, as neither needs to exist.
bool is_same(const Output& output, const fs::path& file) {
  std::error_code ignored;
  return fs::equivalent(output.file, file, ignored) || output.resolved == resolved(file);
}

std::vector<Output> outputs_of(const DiffArguments& arguments) {
  std::vector<Output> outputs;
  const auto add = [&](std::string_view what, const std::string& file) {
    std::error_code ignored;
    if (file.empty() || fs::is_other(file, ignored)) return;
    outputs.push_back({what, file, resolved(file)});
  };
  add("the heat map", arguments.heat_map);
  for (const auto& [option, file] : {std::pair("--json", &arguments.json), std::pair("--csv", &arguments.csv),
                                     std::pair("--junit", &arguments.junit)})
    if (*file != "-") add(option, *file);
  return outputs;
}

std::string replaces_input(const Output& output, const std::vector<FilePair>& pairs,
                           const fs::path& tolerances) {
  const auto text = [&](std::string_view purpose) {
    return fmt::format("{} would replace '{}', which {}", output.what, output.file.string(), purpose);
  };
  for (const FilePair& pair : pairs)
    for (const auto& picture : {pair.reference, pair.test})
      if (picture && is_same(output, *picture)) return text("is to be compared");
  return !tolerances.empty() && is_same(output, tolerances) ? text("holds the tolerances") : "";
}

}  // namespace

std::string output_conflict(const DiffArguments& arguments, bool folders,
                            const std::vector<FilePair>& pairs) {
  fs::path tolerances = arguments.tolerances;
  if (tolerances.empty() && folders) tolerances = fs::path(arguments.reference) / "tolerances.json";
  const std::vector<Output> outputs = outputs_of(arguments);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (std::string text = replaces_input(outputs[i], pairs, tolerances); !text.empty()) return text;
    for (std::size_t j = 0; j < i; ++j)
      if (is_same(outputs[i], outputs[j].file))
        return fmt::format("{} would replace '{}', which is {}'s", outputs[i].what, outputs[i].file.string(),
                           outputs[j].what);
  }
  return "";
}

}  // namespace trace
