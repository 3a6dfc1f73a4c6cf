#include <fmt/format.h>

#include "rendering/render.hpp"
#include "tools/benchmark/kernels/frame_rays.hpp"
#include "tools/benchmark/kernels/mesh_scene.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

bool wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

template <class Frame>
void measure(const char* interface, Mode mode, int repetitions, Frame&& frame) {
  const FrameCounts counts = frame();
  const Times times = repeated(repetitions, frame);
  fmt::print(
      "rays mode={} interface={} rays={} hits={} shadow={} occluded={} {} Mrays/s={:.4f} distances={:.9g}\n",
      mode_names[static_cast<int>(mode)], interface, counts.rays(), counts.hits, counts.shadow,
      counts.occluded, times.text(), static_cast<double>(counts.rays()) / times.median() / 1000,
      counts.distances);
}

}  // namespace

void measure_rays(const RayArguments& arguments) {
  const MeshScene meshes = read_mesh_scene(arguments.scene, arguments.width);
  const Scene& scene = meshes.scene;
  const SceneTree tree(scene);
  const FrameSize size{arguments.width, static_cast<int>(picture_height(scene, arguments.width))};
  for (const Mode mode : modes) {
    if (!wanted(arguments.modes, mode_names[static_cast<int>(mode)])) continue;
    if (wanted(arguments.interfaces, "single")) {
      measure("single", mode, arguments.repetitions,
              [&] { return single_frame(scene, tree, size, mode, meshes.extra_light); });
    }
    if (has_coherent_frames() && wanted(arguments.interfaces, "coherent")) {
      measure("coherent", mode, arguments.repetitions,
              [&] { return coherent_frame(scene, tree, size, mode, meshes.extra_light); });
    }
  }
}

}  // namespace trace::bench
