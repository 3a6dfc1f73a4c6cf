// The one place that knows how rays are traced in packets.
#include <stdexcept>

#include "tools/benchmark/kernels/frame_rays.hpp"

namespace trace::bench {

bool has_coherent_frames() {
  return false;
}

FrameCounts coherent_frame(const Scene&, const SceneTree&, FrameSize, Mode, const Vec3&) {
  throw std::runtime_error("this build traces no packets");
}

}  // namespace trace::bench
