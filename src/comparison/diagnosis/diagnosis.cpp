// The order of the hypotheses: those that predict every pixel first, those that only constrain the residual
// last.
#include "comparison/diagnosis/diagnosis.hpp"

#include "comparison/diagnosis/diagnosis_edges.hpp"
#include "comparison/diagnosis/diagnosis_geometry.hpp"
#include "comparison/diagnosis/diagnosis_limits.hpp"
#include "comparison/diagnosis/diagnosis_scene.hpp"
#include "comparison/diagnosis/diagnosis_tone.hpp"

namespace trace {
namespace {

// How much less the best of the exact hypotheses must leave over than one of another kind, where both are
// accepted. Below that the pictures do not tell the two apart.
constexpr double clearly_better = 4;
constexpr double equal = 0.001;

// Each predicts every pixel of the test picture from the reference.
std::optional<Diagnosis> exact(const PicturePair& pair, bool& several) {
  std::optional<Finding> best;
  double runner_up = 1;
  for (const auto find : {find_channel_order, find_flip, find_shift, find_tone}) {
    auto found = find(pair);
    if (!found) continue;
    if (!best || found->unexplained < best->unexplained) std::swap(best, found);
    if (found) runner_up = std::min(runner_up, found->unexplained);
  }
  several = best && runner_up <= clearly_better * best->unexplained + equal;
  if (several) return std::nullopt;
  if (!best) best = find_mirrored_axis(pair);
  if (!best) return std::nullopt;
  return best->diagnosis;
}

}  // namespace

std::string_view name(Diagnosis::Kind kind) {
  switch (kind) {
    case Diagnosis::Kind::shifted:
      return "shifted";
    case Diagnosis::Kind::flipped:
      return "flipped";
    case Diagnosis::Kind::channels_swapped:
      return "channels-swapped";
    case Diagnosis::Kind::gamma:
      return "gamma";
    case Diagnosis::Kind::brightness:
      return "brightness";
    case Diagnosis::Kind::shadows_missing:
      return "shadows-missing";
    case Diagnosis::Kind::reflection_missing:
      return "reflection-missing";
    case Diagnosis::Kind::object_missing:
      return "object-missing";
    case Diagnosis::Kind::object_displaced:
      return "object-displaced";
    case Diagnosis::Kind::edges:
      return "edges";
    case Diagnosis::Kind::blank:
      return "blank";
    case Diagnosis::Kind::wrapped:
      return "wrapped";
    case Diagnosis::Kind::specular_missing:
      return "specular-missing";
  }
  return "";
}

std::optional<Diagnosis> diagnose(const Raster& reference, const Raster& test, const Measurements&) {
  const auto pair = make_pair(reference, test);
  if (!pair || pair->differing.size() < least_pixels_to_judge) return std::nullopt;
  if (auto found = find_blank(*pair)) return found->diagnosis;
  bool several = false;
  if (auto found = exact(*pair, several); found || several) return found;
  for (const auto find : {find_wrapped, find_edges, find_scene})
    if (auto found = find(*pair)) return found->diagnosis;
  return std::nullopt;
}

}  // namespace trace
