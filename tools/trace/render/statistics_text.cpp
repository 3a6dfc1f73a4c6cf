#include <fmt/format.h>

#include "tools/trace/render/statistics.hpp"

namespace trace {
namespace {

std::string hierarchy_text(const std::optional<HierarchyStatistics>& h) {
  if (!h) return "none: a handful of objects is a list";
  return fmt::format("{} nodes over {}, surface-area cost {:.1f}", h->nodes,
                     h->faces > 0 ? fmt::format("{} faces", h->faces) : "the objects", h->surface_area_cost);
}

std::string left_out_text(const Statistics& s) {
  std::string text = s.everything_modelled ? "modelled everything, needed or not\n" : "";
  for (const LeftOut& left : s.left_out) text += fmt::format("left out {} ({})\n", left.what, left.why);
  return text;
}

}  // namespace

std::string to_text(const Statistics& s) {
  const auto ms = [&](Stage stage) { return s.clock.milliseconds(stage); };
  const WorkCounts& work = s.rays.work;
  std::string text = fmt::format(
      "scene    {} objects, {} triangles, {} lights, {} textures\n"
      "picture  {} x {}\n"
      "rays     {} primary, {} reflected, {} refracted, {} shadow\n"
      "time     {:.1f} ms start, {:.1f} ms load ({:.1f} read, {:.1f} parse, {:.1f} scene, {:.1f} textures), "
      "{:.1f} ms build, {:.1f} ms render, {:.1f} ms write\n"
      "memory   {:.1f} MB at most\n",
      s.objects, s.triangles, s.lights, s.textures, s.width, s.height, s.rays.primary, s.rays.reflected,
      s.rays.refracted, s.rays.shadow, ms(Stage::start), ms(Stage::load), s.load.read, s.load.parse,
      s.scene_milliseconds(), s.decoded.milliseconds, ms(Stage::build), ms(Stage::render), ms(Stage::write),
      static_cast<double>(s.peak_bytes) / (1024.0 * 1024.0));
  text += fmt::format(
      "bytes    {} text, {} description, {} scene, {} textures, {} hierarchies, {} picture, {} file\n",
      s.sizes.text, s.sizes.description, s.scene_bytes.meshes + s.scene_bytes.rest, s.scene_bytes.textures,
      s.hierarchy_bytes, s.picture_bytes, s.file_bytes ? std::to_string(*s.file_bytes) : "unknown");
  text += fmt::format("decoded  {} by libpng, {} by stb, {} by OpenImageIO\n", s.decoded.by_libpng,
                      s.decoded.by_stb, s.decoded.by_openimageio);
  text += fmt::format(
      "spared   {} shadow rays: {} of culled lights, {} of opaque backs, {} where nothing is reflected, {} "
      "out of reach, {} of lights behind; {} faint rays\n",
      work.shadows.total(), work.shadows.culled, work.shadows.from_back, work.shadows.reflects_nothing,
      work.shadows.out_of_reach, work.shadows.behind, work.faint);
  text += fmt::format("work     {} powers of highlights, {} surfaces with maps, {} lookups of surroundings\n",
                      work.highlights, work.maps, work.surroundings);
  return text + fmt::format("kernels  {}\nhierarchy {}\n{}", name_of(s.instruction_set),
                            hierarchy_text(s.hierarchy), left_out_text(s));
}

}  // namespace trace
