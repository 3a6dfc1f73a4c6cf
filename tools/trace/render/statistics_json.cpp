#include <nlohmann/json.hpp>

#include "tools/trace/render/statistics.hpp"

namespace trace {
namespace {

using json = nlohmann::ordered_json;

json stage(const char* name, double milliseconds, const json& bytes) {
  return {{"stage", name}, {"milliseconds", milliseconds}, {"bytes", bytes}};
}

json stages(const Statistics& s) {
  const auto ms = [&](Stage stage) { return s.clock.milliseconds(stage); };
  return json::array({stage("start", ms(Stage::start), json()), stage("read", s.load.read, s.sizes.text),
                      stage("parse", s.load.parse, s.sizes.description),
                      stage("scene", s.scene_milliseconds(), s.scene_bytes.meshes + s.scene_bytes.rest),
                      stage("textures", s.decoded.milliseconds, s.scene_bytes.textures),
                      stage("hierarchy", ms(Stage::build), s.hierarchy_bytes),
                      stage("render", ms(Stage::render), s.picture_bytes),
                      stage("write", ms(Stage::write), s.file_bytes ? json(*s.file_bytes) : json())});
}

json needs(const SceneNeeds& n) {
  return {{"transmission", n.transmission},
          {"reflection", n.reflection},
          {"highlights", n.highlights},
          {"maps", n.maps},
          {"surroundings", n.surroundings},
          {"smooth_normals", n.smooth_normals},
          {"vertex_materials", n.vertex_materials}};
}

json spared(const WorkCounts& work) {
  return {{"culled_light", work.shadows.culled},
          {"opaque_back", work.shadows.from_back},
          {"nothing_reflected", work.shadows.reflects_nothing},
          {"out_of_reach", work.shadows.out_of_reach},
          {"light_behind", work.shadows.behind}};
}

json left_out_list(const Statistics& s) {
  json list = json::array();
  for (const LeftOut& left : s.left_out) list.push_back({{"what", left.what}, {"why", left.why}});
  return list;
}

json culled_list(const Statistics& s) {
  json list = json::array();
  for (const CulledLight& culled : s.culled_lights)
    list.push_back({{"light", culled.light}, {"why", to_text(culled.why)}});
  return list;
}

json hierarchy(const Statistics& s) {
  if (!s.hierarchy) return {};
  return {{"nodes", s.hierarchy->nodes},
          {"over", s.hierarchy->faces > 0 ? "faces" : "objects"},
          {"items", s.hierarchy->faces > 0 ? s.hierarchy->faces : s.objects},
          {"surface_area_cost", s.hierarchy->surface_area_cost}};
}

}  // namespace

std::string to_json(const Statistics& s) {
  const WorkCounts& work = s.rays.work;
  const json result = {
      {"format", "trace-stats"},
      {"version", 1},
      {"scene",
       {{"objects", s.objects}, {"triangles", s.triangles}, {"lights", s.lights}, {"textures", s.textures}}},
      {"picture", {{"width", s.width}, {"height", s.height}}},
      {"everything_modelled", s.everything_modelled},
      {"needs", needs(s.needs)},
      {"left_out", left_out_list(s)},
      {"culled_lights", culled_list(s)},
      {"rays",
       {{"primary", s.rays.primary},
        {"reflected", s.rays.reflected},
        {"refracted", s.rays.refracted},
        {"shadow", s.rays.shadow}}},
      {"shadow_rays_spared", spared(work)},
      {"faint_rays", work.faint},
      {"work", {{"highlights", work.highlights}, {"maps", work.maps}, {"surroundings", work.surroundings}}},
      {"decoded",
       {{"by_libpng", s.decoded.by_libpng},
        {"by_stb", s.decoded.by_stb},
        {"by_openimageio", s.decoded.by_openimageio},
        {"file_bytes", s.decoded.file_bytes},
        {"pixel_bytes", s.decoded.pixel_bytes}}},
      {"instruction_set", name_of(s.instruction_set)},
      {"hierarchy", hierarchy(s)},
      {"stages", stages(s)},
      {"peak_bytes", s.peak_bytes}};
  return result.dump(1) + "\n";
}

}  // namespace trace
