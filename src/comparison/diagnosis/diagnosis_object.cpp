#include "comparison/diagnosis/diagnosis_object.hpp"

#include <fmt/format.h>

namespace trace {
namespace {

// One thing: its shadow and its mirror image may differ apart from it, but not by more.
constexpr double least_worst = 0.4;
// Of the outline, what must be hard for the rest to say anything.
constexpr double least_hard = 0.6;
// Of the hard outline, what may have stayed: where others stand before or behind it.
constexpr double most_kept = 0.15;
// A surface, not lines along edges.
constexpr double least_thick = 0.4;
// Of the parts of the picture with edges, what a single object's way may touch.
constexpr double most_parts = 0.6;
// A region that is worth naming, of the squared error.
constexpr double of_note = 0.05;

std::string place(const Region& box) {
  return fmt::format("({}, {}) to ({}, {})", box.x0, box.y0, box.x1 - 1, box.y1 - 1);
}

Region enclosing(const std::vector<DifferingRegion>& regions, double energy) {
  Region box = regions[0].box;
  for (const DifferingRegion& region : regions) {
    if (region.energy < of_note * energy) continue;
    box.x0 = std::min(box.x0, region.box.x0);
    box.y0 = std::min(box.y0, region.box.y0);
    box.x1 = std::max(box.x1, region.box.x1);
    box.y1 = std::max(box.y1, region.box.y1);
  }
  return box;
}

}  // namespace

std::optional<Diagnosis> find_object(const std::vector<DifferingRegion>& regions, const EdgeCounts& outline,
                                     const DifferenceSigns& signs, const EdgeSigns& edges) {
  double energy = 0;
  for (const DifferingRegion& region : regions) energy += region.energy;
  const double hard = 1 - outline.share(outline.soft);
  if (hard < least_hard || regions[0].energy < least_worst * energy || edges.thick < least_thick ||
      outline.share(outline.kept) > most_kept * hard)
    return std::nullopt;
  const double vanished = outline.share(outline.vanished) / hard,
               appeared = outline.share(outline.appeared) / hard;

  if (vanished >= 0.8 && appeared <= 0.1) {
    // What is only darker on a lit ground may be a mirror image; on a black ground, an object without light.
    const bool only_darker = signs.brighter <= 0.005;
    if (only_darker && signs.black_in_test < 0.9) return std::nullopt;
    return Diagnosis{
        Diagnosis::Kind::object_missing,
        fmt::format("an object is missing{} at {}", only_darker ? " or black" : "", place(regions[0].box))};
  }
  // It left one place and came to another.
  if (vanished >= 0.3 && appeared >= 0.3 && edges.parts <= most_parts && signs.brighter >= 0.1 &&
      signs.darker >= 0.1)
    return Diagnosis{Diagnosis::Kind::object_displaced,
                     fmt::format("an object is displaced within {}", place(enclosing(regions, energy)))};
  return std::nullopt;
}

}  // namespace trace
