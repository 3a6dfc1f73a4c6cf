#include "tools/trace/render/statistics.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "scene/needs.hpp"

namespace trace {
namespace {

// "1 234 nodes, surface-area cost 20.1" of the hierarchy of the mesh with the most faces, or of the objects.
std::string hierarchy_text(const Scene& scene, const SceneTree& tree) {
  const Bvh* bvh = tree.is_list() ? nullptr : &tree.bvh();
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    const std::size_t faces = scene.meshes[i].geometry.faces.size();
    if (faces <= most) continue;
    most = faces;
    bvh = &tree.mesh(MeshId{i}).bvh();
  }
  if (!bvh || bvh->nodes.empty()) return "none: a handful of objects is a list";
  return fmt::format("{} nodes over {}, surface-area cost {:.1f}", bvh->nodes.size(),
                     most > 0 ? fmt::format("{} faces", most) : "the objects", surface_area_cost(*bvh));
}

std::string left_out_text(const Scene& scene) {
  std::string text;
  for (const std::string& what : left_out(needs_of(scene))) text += "left out " + what + "\n";
  return text;
}

}  // namespace

void Statistics::lap(Stage stage) {
  const Clock::time_point now = Clock::now();
  milliseconds_[static_cast<std::size_t>(stage)] =
      std::chrono::duration<double, std::milli>(now - last_).count();
  last_ = now;
}

std::string Statistics::report(const Scene& scene, const SceneTree& tree, InstructionSet set,
                               const LoadTimes& load, const Rendered& rendered) const {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [&](Stage stage) { return milliseconds_[static_cast<std::size_t>(stage)]; };
  const RayCounts& rays = rendered.rays;
  return fmt::format(
      "scene    {} objects, {} triangles, {} lights, {} textures\n"
      "picture  {} x {}\n"
      "rays     {} primary, {} reflected, {} refracted, {} shadow\n"
      "time     {:.1f} ms start, {:.1f} ms load ({:.1f} read, {:.1f} parse, {:.1f} scene), {:.1f} ms build, "
      "{:.1f} ms render, {:.1f} ms write\n"
      "memory   {:.1f} MB at most\n"
      "kernels  {}\n"
      "hierarchy {}\n"
      "{}",
      scene.objects.size(), scene.triangle_count(), scene.lights.size(), scene.textures.size(),
      rendered.image.width, rendered.image.height, rays.primary, rays.reflected, rays.refracted, rays.shadow,
      ms(Stage::start), ms(Stage::load), load.read, load.parse, load.build, ms(Stage::build),
      ms(Stage::render), ms(Stage::write), static_cast<double>(usage.ru_maxrss) / 1024.0, name_of(set),
      hierarchy_text(scene, tree), left_out_text(scene));
}

}  // namespace trace
