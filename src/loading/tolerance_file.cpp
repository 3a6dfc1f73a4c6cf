#include "loading/tolerance_file.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <map>

#include "loading/json_keys.hpp"

namespace trace {
namespace {

constexpr std::string_view default_name = "default";

bool fits(const std::string& pattern, std::string_view scene) {
  return fnmatch(pattern.c_str(), std::string(scene).c_str(), 0) == 0;
}

// Characters that stand for themselves: [...] and * and ? are none, \* is one.
std::size_t literal_length(std::string_view pattern) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char c = pattern[i];
    if (c == '*' || c == '?') continue;
    if (c == '\\' && i + 1 < pattern.size()) ++i;
    if (c == '[') {
      const std::size_t end = pattern.find(']', i + 2);
      if (end != pattern.npos) {
        i = end;
        continue;
      }
    }
    ++count;
  }
  return count;
}

bool gives(const JsonValue::Object& object, std::string_view key) {
  return std::ranges::find(object, key, &JsonMember::name) != object.end();
}

// Each name once; JSON itself does not mind.
void check_names(const JsonValue::Object& object, parser::Diagnostics& diagnostics) {
  std::map<std::string_view, parser::Span> seen;
  for (const JsonMember& member : object) {
    const auto [first, is_new] = seen.emplace(member.name, member.name_span);
    if (is_new) continue;
    diagnostics.error(member.name_span, fmt::format("'{}' is given twice", member.name))
        .notes.push_back({first->second, "first given here"});
  }
}

ToleranceEntry read_entry(const JsonMember& member, parser::Diagnostics& diagnostics) {
  ToleranceEntry entry{member.name, member.name_span, {}, ""};
  const auto* object = member.value.get<JsonValue::Object>();
  if (!object) {
    diagnostics.error(member.value.span,
                      fmt::format("'{}' takes an object, such as {{ \"rmse\": 2 }}", member.name));
    return entry;
  }
  check_names(*object, diagnostics);
  Tolerance& t = entry.tolerance;
  t = {std::nullopt, std::nullopt, std::nullopt, 1, std::nullopt, std::nullopt};
  std::optional<double> over;
  std::optional<std::string> reason;
  const JsonKeys keys = {{"rmse", number_or_null_key(&t.rmse)},
                         {"max", number_or_null_key(&t.max)},
                         {"pixels", number_or_null_key(&t.pixels, 0, 100)},
                         {"over", number_key(&over)},
                         {"ssim", number_or_null_key(&t.ssim, -1, 1)},
                         {"flip", number_or_null_key(&t.flip, 0, 1)},
                         {"reason", text_key(&reason)}};
  take_members(*object, keys, "tolerance", false, diagnostics);
  t.over = over.value_or(1);
  entry.reason = reason.value_or("");
  if (gives(*object, "over") && !gives(*object, "pixels")) {
    diagnostics.error(std::ranges::find(*object, "over", &JsonMember::name)->name_span,
                      "'over' needs 'pixels': the share of pixels that may be off by more");
  }
  if (std::ranges::none_of(*object, [](const JsonMember& m) { return m.name != "reason"; })) {
    diagnostics.error(member.name_span, fmt::format("'{}' gives no tolerance", member.name))
        .notes.push_back({member.name_span, "\"rmse\": null accepts any difference"});
  }
  return entry;
}

}  // namespace

std::optional<ToleranceFile> read_tolerances(const parser::Source& source, parser::Diagnostics& diagnostics) {
  const std::optional<JsonValue> root = parse_json(source, diagnostics);
  if (!root) return std::nullopt;
  const auto* object = root->get<JsonValue::Object>();
  if (!object) {
    diagnostics.error(root->span, "a tolerance file holds one object: { \"scene\": { \"rmse\": 2 }, ... }");
    return std::nullopt;
  }
  check_names(*object, diagnostics);
  ToleranceFile file;
  for (const JsonMember& member : *object) {
    ToleranceEntry entry = read_entry(member, diagnostics);
    if (member.name == default_name)
      file.fallback = entry.tolerance;
    else
      file.entries.push_back(std::move(entry));
  }
  if (diagnostics.has_errors()) return std::nullopt;
  return file;
}

const ToleranceEntry* ToleranceFile::find(std::string_view scene) const {
  const ToleranceEntry* best = nullptr;
  for (const ToleranceEntry& entry : entries) {
    if (!fits(entry.name, scene)) continue;
    if (!best || literal_length(entry.name) >= literal_length(best->name)) best = &entry;
  }
  return best;
}

Tolerance ToleranceFile::tolerance(std::string_view scene) const {
  const ToleranceEntry* entry = find(scene);
  return entry ? entry->tolerance : fallback.value_or(Tolerance{});
}

void warn_of_unused(const ToleranceFile& file, const std::vector<std::string_view>& scenes,
                    parser::Diagnostics& diagnostics) {
  for (const ToleranceEntry& entry : file.entries) {
    const auto used = [&](std::string_view scene) { return fits(entry.name, scene); };
    if (std::ranges::any_of(scenes, used)) continue;
    diagnostics.warning(entry.span, fmt::format("no picture is named '{}'", entry.name)).suggestion =
        parser::closest(entry.name, scenes);
  }
}

std::string literal_pattern(std::string_view scene) {
  if (scene == default_name) return "\\" + std::string(scene);
  std::string pattern;
  for (const char c : scene) {
    if (c == '*' || c == '?' || c == '[' || c == '\\') pattern += '\\';
    pattern += c;
  }
  return pattern;
}

}  // namespace trace
