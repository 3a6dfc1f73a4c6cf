#include "tools/trace/render/statistics.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace trace {
namespace {

std::optional<HierarchyStatistics> largest_hierarchy(const Scene& scene, const SceneTree& tree) {
  const Bvh* bvh = tree.is_list() ? nullptr : &tree.bvh();
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    const std::size_t faces = scene.meshes[i].geometry.faces.size();
    if (faces <= most) continue;
    most = faces;
    bvh = &tree.mesh(MeshId{i}).bvh();
  }
  if (!bvh || bvh->nodes.empty()) return std::nullopt;
  return HierarchyStatistics{bvh->nodes.size(), most, surface_area_cost(*bvh)};
}

std::optional<std::uint64_t> size_of_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (error) return std::nullopt;
  return size;
}

// What is left out beside what the scene's values say.
void add_structures(std::vector<LeftOut>& list, const SceneTree& tree, InstructionSet set) {
  if (tree.is_list()) list.push_back({"a hierarchy over the objects", "a handful of objects is a list"});
  if (set == InstructionSet::baseline) list.push_back({"packets of rays", "the instruction set is baseline"});
}

}  // namespace

double Statistics::scene_milliseconds() const {
  return std::max(0.0, clock.milliseconds(Stage::load) - load.read - load.parse - decoded.milliseconds);
}

Statistics statistics_of(const StageClock& clock, const LoadedScene& loaded, const FileImages& images,
                         const SceneTree& tree, const RenderOptions& options, const Rendered& rendered,
                         const std::filesystem::path& output) {
  const Scene& scene = *loaded.scene;
  Statistics s;
  s.objects = scene.objects.size();
  s.triangles = scene.triangle_count();
  s.lights = scene.lights.size();
  s.textures = scene.textures.size();
  s.needs = needs_of(scene);
  s.everything_modelled = options.shading.model_everything;
  s.left_out = left_out(scene, s.everything_modelled);
  add_structures(s.left_out, tree, options.instruction_set);
  if (!s.everything_modelled) s.culled_lights = lights_that_count(scene).culled;
  s.instruction_set = options.instruction_set;
  s.hierarchy = largest_hierarchy(scene, tree);
  s.width = rendered.image.width;
  s.height = rendered.image.height;
  s.rays = rendered.rays;
  s.decoded = images.decoded();
  s.clock = clock;
  s.load = loaded.times;
  s.sizes = loaded.sizes;
  s.scene_bytes = bytes_of(scene);
  s.hierarchy_bytes = tree.bytes();
  s.picture_bytes = rendered.image.rgb.size();
  s.file_bytes = size_of_file(output);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  s.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return s;
}

}  // namespace trace
