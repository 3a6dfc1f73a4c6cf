#include "comparison/diagnosis/diagnosis_scene.hpp"

#include <fmt/format.h>

#include "comparison/diagnosis/diagnosis_edges.hpp"
#include "comparison/diagnosis/diagnosis_object.hpp"
#include "comparison/diagnosis/diagnosis_regions.hpp"
#include "comparison/diagnosis/diagnosis_signs.hpp"

namespace trace {
namespace {

// Of the differing pixels, what may go the other way: rounding in mirrors and at edges.
constexpr double most_other_way = 0.005;
// Of what is lit, the share that stays as it is: most, where shadows or highlights are missing; not, where a
// light has another brightness.
constexpr double most_stays = 0.5;
// The least that any cause here leaves alone.
constexpr double least_stays = 0.3;

bool never_darker(const DifferenceSigns& signs) {
  return signs.darker <= most_other_way;
}
bool never_brighter(const DifferenceSigns& signs) {
  return signs.brighter <= most_other_way;
}

bool shadows_missing(double equal, const DifferenceSigns& signs, const EdgeCounts& outline,
                     std::size_t pixels) {
  if (!never_darker(signs) || equal < most_stays) return false;
  // Highlights, and mirrors in the shadow, may have colours of their own; or the shadows are black.
  const bool same_surface = signs.same_color >= 0.95;
  const bool black = static_cast<double>(signs.colored) <= 0.05 * static_cast<double>(pixels);
  if (!same_surface && !black) return false;
  // A part of a shadow's edge lies on an even surface, however much of it follows the outlines of objects.
  const double vanished = outline.share(outline.vanished), appeared = outline.share(outline.appeared);
  if (vanished < 0.2 || appeared > vanished + 0.15) return false;
  // An outline with both and nothing else is that of something that moved.
  return appeared == 0 || outline.kept > 0;
}

bool reflection_missing(double equal, const DifferenceSigns& signs, const EdgeCounts& outline,
                        const EdgeCounts& inside) {
  if (!never_brighter(signs)) return false;
  const double soft = outline.share(outline.soft), vanished = outline.share(outline.vanished),
               vanished_inside = inside.share(inside.vanished);
  // Images of objects in surfaces that are still seen; where they are not, an object could as well be
  // missing.
  const bool images = equal >= 0.4 && signs.black_in_test <= 0.3 && soft <= 0.3 && vanished >= 0.4 &&
                      vanished_inside >= 0.45 && inside.total() >= 50;
  // Mirrors as a whole: the outlines stay, what they showed is gone and was of many colours.
  const bool whole_mirrors = soft <= 0.1 && vanished <= 0.35 && vanished_inside >= 0.75 &&
                             inside.total() >= 50 && signs.difference_of_one_color <= 0.72;
  return images || whole_mirrors;
}

bool specular_missing(double equal, const DifferenceSigns& signs, const EdgeCounts& outline,
                      const EdgeCounts& inside, const EdgeSigns& edges, std::size_t pixels) {
  return never_brighter(signs) && outline.share(outline.soft) >= 0.8 &&
         signs.difference_of_same_color <= 0.3 && equal >= most_stays &&
         inside.share(inside.vanished) >= 0.4 &&
         static_cast<double>(edges.pixels) >= 0.3 * static_cast<double>(pixels);  // more than noise
}

}  // namespace

std::optional<Finding> find_scene(const PicturePair& pair) {
  const double equal = lit_and_equal(pair);
  if (equal < least_stays) return std::nullopt;
  const DifferenceSigns signs = difference_signs(pair);
  const std::vector<DifferingRegion> regions = differing_regions(pair);
  if (regions.empty()) return std::nullopt;
  EdgeCounts outline, inside;
  for (const DifferingRegion& region : regions) {
    outline += region.outline;
    inside += region.inside;
  }
  if (shadows_missing(equal, signs, outline, pair.differing.size()))
    return Finding{{Diagnosis::Kind::shadows_missing, "shadows are missing"}, signs.darker};
  if (reflection_missing(equal, signs, outline, inside))
    return Finding{{Diagnosis::Kind::reflection_missing, "reflected or refracted light is missing"},
                   signs.brighter};
  const EdgeSigns edges = edge_signs(pair);
  if (specular_missing(equal, signs, outline, inside, edges, pair.differing.size()))
    return Finding{{Diagnosis::Kind::specular_missing, "highlights are missing"}, signs.brighter};
  if (auto diagnosis = find_object(regions, outline, signs, edges)) return Finding{*diagnosis, 0};
  return std::nullopt;
}

}  // namespace trace
