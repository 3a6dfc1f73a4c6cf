#include "loading/settings_file.hpp"

#include <fmt/format.h>

namespace trace {
namespace {

constexpr int any_limit = 1'000'000;  // for keys without effect

JsonKey transmissive_shadows_key(std::optional<TransmissiveShadows>* target) {
  return {"\"distance\", \"surface\" or \"none\"", [target](const JsonValue& value) {
            const std::string* name = value.get<std::string>();
            const auto rule = name ? transmissive_shadows_named(*name) : std::nullopt;
            if (rule) *target = rule;
            return rule.has_value();
          }};
}

}  // namespace

JsonKeys settings_keys(Settings& settings) {
  return {{"size", whole_key(&settings.size, 1, max_width)},
          {"recursion_depth", whole_key(&settings.recursion_depth, -max_depth, max_depth)},
          {"threads", whole_key(&settings.threads, 1, 1024)},
          {"shadows", boolean_key(&settings.shadows)},
          {"smoothshade", boolean_key(&settings.smoothshade)},
          {"backface_culling", boolean_key(&settings.backface_culling)},
          {"internal_reflection", boolean_key(&settings.internal_reflection)},
          {"backface_specular", boolean_key(&settings.backface_specular)},
          {"anti_alias", boolean_key(&settings.anti_alias)},
          {"supersamples", whole_key(&settings.supersamples, 1, max_supersamples)},
          {"aa_threshold", number_key(&settings.aa_threshold)},
          {"threshold", number_key(&settings.threshold)},
          {"blocksize", whole_key(&settings.blocksize, 1, max_block_size)},
          {"light_samples", whole_key(&settings.light_samples, 1, max_light_samples)},
          {"transmissive_shadows", transmissive_shadows_key(&settings.transmissive_shadows)},
          {"kdtree", boolean_key(nullptr)},
          {"tree_depth", whole_key(nullptr, 0, any_limit)},
          {"leaf_size", whole_key(nullptr, 0, any_limit)},
          {"filter_width", whole_key(nullptr, 0, any_limit)}};
}

SettingsFile read_settings(const std::string& file) {
  SettingsFile result;
  std::optional<parser::Source> source;
  try {
    source = parser::Source::from_file(file);
  } catch (const std::runtime_error& e) {
    result.valid = false;
    result.messages = fmt::format("trace: error: {}\n", e.what());
    return result;
  }
  parser::Diagnostics diagnostics;
  if (const std::optional<JsonValue> root = parse_json(*source, diagnostics)) {
    if (const auto* object = root->get<JsonValue::Object>()) {
      take_members(*object, settings_keys(result), "setting", true, diagnostics);
    } else {
      diagnostics.error({0, 1}, "a settings file holds one object: { \"key\": value, ... }");
    }
  }
  result.valid = !diagnostics.has_errors();
  result.messages = parser::render(*source, diagnostics);
  return result;
}

void Settings::apply(RenderOptions& options) const {
  const auto set = [](auto& target, const auto& value) {
    if (value) target = *value;
  };
  set(options.width, size);
  set(options.depth, recursion_depth);
  if (options.depth < 0) options.depth = 0;
  set(options.threads, threads);
  set(options.shading.shadows, shadows);
  set(options.shading.smooth_shading, smoothshade);
  set(options.shading.backface_culling, backface_culling);
  set(options.shading.internal_reflection, internal_reflection);
  set(options.shading.backface_specular, backface_specular);
  set(options.antialiasing.enabled, anti_alias);
  set(options.antialiasing.supersamples, supersamples);
  set(options.antialiasing.threshold, aa_threshold);
  set(options.blocks.threshold, threshold);
  set(options.blocks.size, blocksize);
  set(options.shading.light_samples, light_samples);
  set(options.shading.transmissive_shadows, transmissive_shadows);
}

}  // namespace trace
