#include "batch/batch_file.hpp"

#include <fmt/format.h>

#include "batch/scene_list.hpp"
#include "loading/json_keys.hpp"

namespace trace {

void SceneOptions::add(const SceneOptions& other) {
  const auto replace = [](auto& target, const auto& value) {
    if (value) target = value;
  };
  replace(depth, other.depth);
  replace(width, other.width);
  replace(cube_map, other.cube_map);
  replace(timeout, other.timeout);
  replace(memory, other.memory);
  settings.insert(settings.end(), other.settings.begin(), other.settings.end());
}

// Takes the values of one file.
struct BatchFile::Reader {
  BatchFile& file;
  std::filesystem::path folder;
  parser::Diagnostics& diagnostics;
  std::string messages;  // of the settings files it names
  bool settings_valid = true;

  static JsonKey object(std::function<void(const JsonValue::Object&)> take) {
    return {"an object: { ... }", [take = std::move(take)](const JsonValue& value) {
              const auto* members = value.get<JsonValue::Object>();
              if (members) take(*members);
              return members != nullptr;
            }};
  }

  std::string from_folder(const std::string& name) const { return (folder / name).string(); }

  JsonKey settings_key(SceneOptions& options) {
    return {"a file's name or an object of settings", [this, &options](const JsonValue& value) {
              Settings settings;
              if (const auto* members = value.get<JsonValue::Object>()) {
                take_members(*members, settings_keys(settings), "setting", true, diagnostics);
              } else if (const auto* name = value.get<std::string>()) {
                SettingsFile read = read_settings(from_folder(*name));
                messages += read.messages;
                settings_valid &= read.valid;
                settings = read;
              } else {
                return false;
              }
              options.settings.push_back(settings);
              return true;
            }};
  }

  SceneOptions options(const JsonValue::Object& members) {
    SceneOptions result;
    take_members(members,
                 {{"depth", whole_key(&result.depth, 0, max_depth)},
                  {"width", whole_key(&result.width, 1, max_width)},
                  {"cubemap", text_key(&result.cube_map)},
                  {"timeout", number_key(&result.timeout, 0.001, 1e6)},
                  {"memory", number_key(&result.memory, 1, 1e6)},
                  {"settings", settings_key(result)}},
                 "option of a scene", false, diagnostics);
    if (result.cube_map) result.cube_map = from_folder(*result.cube_map);
    return result;
  }

  void scenes(const JsonValue::Object& members) {
    for (const JsonMember& member : members) {
      const auto* object = member.value.get<JsonValue::Object>();
      if (object) {
        file.entries_.push_back({member.name, options(*object)});
      } else {
        diagnostics.error(member.value.span, fmt::format("'{}' takes an object: {{ ... }}", member.name));
      }
    }
  }

  JsonKey exclude_key() {
    return {"a list of patterns in quotes", [this](const JsonValue& value) {
              const auto* list = value.get<JsonValue::Array>();
              if (!list) return false;
              for (const JsonValue& element : *list) {
                const auto* pattern = element.get<std::string>();
                if (!pattern) return false;
                file.exclude_.push_back(*pattern);
              }
              return true;
            }};
  }

  void all(const JsonValue& root) {
    const auto* members = root.get<JsonValue::Object>();
    if (!members) {
      diagnostics.error({0, 1}, "batch.json holds one object: { \"default\": ..., \"scenes\": ... }");
      return;
    }
    take_members(*members,
                 {{"default", object([this](const auto& m) {
                     file.entries_.insert(file.entries_.begin(), {"**", options(m)});
                   })},
                  {"scenes", object([this](const auto& m) { scenes(m); })},
                  {"exclude", exclude_key()}},
                 "key", false, diagnostics);
  }
};

std::optional<BatchFile> BatchFile::read(const std::filesystem::path& path, std::string& messages,
                                         bool& valid) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  std::optional<parser::Source> source;
  try {
    if (!std::filesystem::is_regular_file(path, ignored))
      throw std::runtime_error(fmt::format("'{}' is not a file", path.string()));
    source = parser::Source::from_file(path.string());
  } catch (const std::runtime_error& e) {
    messages += fmt::format("trace: error: {}\n", e.what());
    valid = false;
    return std::nullopt;
  }
  parser::Diagnostics diagnostics;
  BatchFile file;
  Reader reader{file, path.parent_path(), diagnostics, {}};
  if (const std::optional<JsonValue> root = parse_json(*source, diagnostics)) reader.all(*root);
  messages += parser::render(*source, diagnostics) + reader.messages;
  valid &= !diagnostics.has_errors() && reader.settings_valid;
  return file;
}

SceneOptions BatchFile::of(const std::string& scene) const {
  SceneOptions result;
  for (const Entry& entry : entries_) {
    if (matches(entry.pattern, scene)) result.add(entry.options);
  }
  return result;
}

}  // namespace trace
