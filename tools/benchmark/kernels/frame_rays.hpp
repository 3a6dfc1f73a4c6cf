// The rays of one frame over meshes, which other libraries trace too: primary rays through the lower left
// corners of the pixels, then from each hit, if any, shadow rays or one mirrored at the face as it is,
// without smoothing. In tiles of 32 x 32 pixels, from the lower left.
#pragma once

#include <cstdint>

#include "acceleration/scene_tree.hpp"

namespace trace::bench {

enum class Mode { primary, one_shadow, all_shadows, mirrored };

inline constexpr Mode modes[] = {Mode::primary, Mode::one_shadow, Mode::all_shadows, Mode::mirrored};
inline constexpr const char* mode_names[] = {"primary", "prim+1shadow", "prim+allshadows", "prim+1reflect"};
inline constexpr int tile_side = 32;

struct FrameSize {
  int width, height;
};

struct FrameCounts {
  std::uint64_t primary = 0, hits = 0, shadow = 0, occluded = 0, mirrored = 0;
  double distances = 0;  // of all hits together

  std::uint64_t rays() const { return primary + shadow + mirrored; }
};

// One thread, a ray at a time. `one_shadow` sends one to `extra_light` from every hit, whichever side it is
// on; `all_shadows` one to each of the scene's lights that the face is turned to as it is seen.
FrameCounts single_frame(const Scene& scene, const SceneTree& tree, FrameSize size, Mode mode,
                         const Vec3& extra_light);

// Whether rays can be traced in packets in this build on this machine.
bool has_coherent_frames();

// The same rays in packets, as the renderer traces them: those of neighbouring pixels, and what goes on from
// their hits, to the same light or mirrored.
FrameCounts coherent_frame(const Scene& scene, const SceneTree& tree, FrameSize size, Mode mode,
                           const Vec3& extra_light);

// Calls visit(x, y) for all pixels, tile by tile.
template <class Visit>
void for_each_pixel(FrameSize size, Visit&& visit) {
  for (int top = 0; top < size.height; top += tile_side) {
    for (int left = 0; left < size.width; left += tile_side) {
      const int bottom = std::min(size.height, top + tile_side),
                right = std::min(size.width, left + tile_side);
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) visit(x, y);
      }
    }
  }
}

}  // namespace trace::bench
