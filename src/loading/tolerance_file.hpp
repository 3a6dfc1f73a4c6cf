// Tolerances scene by scene: the file tolerances.json beside the solutions.
//
//   { "default": { "rmse": 0.5, "pixels": 0.1, "over": 1 },
//     "simple/box": { "max": 3 },
//     "polymesh/*": { "rmse": 2, "reason": "the solutions are antialiased" } }
//
// Names are relative paths without extension; * ? [...] are those of the shell, and * goes on over slashes.
// Of several that fit a scene the one with most literal characters counts, of equally literal ones the last.
// An entry stands for itself: what it does not give is not looked at. null says so in so many words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/judge.hpp"
#include "parser/diagnostic.hpp"

namespace trace {

inline constexpr std::string_view tolerance_file_name = "tolerances.json";

struct ToleranceEntry {
  std::string name;  // a pattern, or "default"
  parser::Span span;
  Tolerance tolerance;
  std::string reason;  // for people
};

struct ToleranceFile {
  std::vector<ToleranceEntry> entries;  // in the order of the file, without "default"
  std::optional<Tolerance> fallback;    // "default"

  // The entry for a scene; null where none fits.
  const ToleranceEntry* find(std::string_view scene) const;
  // Of that entry, else of "default", else the program's own.
  Tolerance tolerance(std::string_view scene) const;
};

// Nothing where the text has errors; they are in `diagnostics`.
std::optional<ToleranceFile> read_tolerances(const parser::Source& source, parser::Diagnostics& diagnostics);

// Warns of entries that fit none of the scenes.
void warn_of_unused(const ToleranceFile& file, const std::vector<std::string_view>& scenes,
                    parser::Diagnostics& diagnostics);

// A pattern that fits this scene only.
std::string literal_pattern(std::string_view scene);

}  // namespace trace
