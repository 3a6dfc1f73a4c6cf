// The course's settings file: one JSON object, applied over the command line.
#pragma once

#include <optional>
#include <string>

#include "loading/json_keys.hpp"
#include "rendering/options.hpp"

namespace trace {

// Only what the file gives is set. Keys that do not change the picture (kdtree, tree_depth, leaf_size,
// filter_width) are checked and have no effect; other unknown keys are warned of.
struct Settings {
  std::optional<int> size, recursion_depth, threads, supersamples, blocksize;
  std::optional<bool> shadows, smoothshade, backface_culling, internal_reflection, backface_specular,
      anti_alias;
  std::optional<double> aa_threshold, threshold;
  std::optional<int> light_samples;  // ours
  std::optional<TransmissiveShadows> transmissive_shadows;

  void apply(RenderOptions& options) const;
};

struct SettingsFile : Settings {
  bool valid = true;
  std::string messages;  // errors and warnings, `file:line:column: ...`
};

// The keys of a settings object; `settings` must outlive them.
JsonKeys settings_keys(Settings& settings);

SettingsFile read_settings(const std::string& file);

}  // namespace trace
