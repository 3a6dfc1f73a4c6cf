// Pictures with only what a scene needs, and with everything modelled.
#pragma once

#include "tests/support/scene_picture.hpp"

namespace trace::test {

struct NeededAndAll {
  Rendered needed, all;
};

inline Rendered rendered_counting(const Scene& scene, RenderOptions options, InstructionSet set,
                                  bool everything) {
  options.instruction_set = set;
  options.shading.model_everything = everything;
  options.shading.count_work = true;
  const SceneTree tree(scene, 1, set, everything);
  Progress progress;
  return render(scene, tree, options, progress);
}

// Rendered both ways by single rays, and again by packets, which must agree.
inline NeededAndAll needed_and_all(const Scene& scene, const RenderOptions& options) {
  const auto both = [&](bool everything) {
    const Rendered single = rendered_counting(scene, options, InstructionSet::baseline, everything);
    const Rendered packets = rendered_counting(scene, options, best_instruction_set(), everything);
    CHECK(packets.image.rgb == single.image.rgb);
    CHECK(packets.rays == single.rays);
    return single;
  };
  NeededAndAll result{both(false), both(true)};
  CHECK(result.all.image.rgb == result.needed.image.rgb);
  CHECK(result.all.rays.primary == result.needed.rays.primary);
  return result;
}

}  // namespace trace::test
