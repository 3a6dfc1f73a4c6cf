// What `--stats` and `--stats-json` report of a run: what the scene holds and needs, what was traced and what
// was spared and why, and the time and bytes of each stage.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/image_source.hpp"
#include "loading/scene_loader.hpp"
#include "rendering/render.hpp"
#include "scene/counting_lights.hpp"
#include "scene/needs.hpp"
#include "scene/scene_bytes.hpp"
#include "tools/trace/render/stage_clock.hpp"

namespace trace {

// Of the hierarchy of the mesh with the most faces, or of the objects; nothing where they are a list.
struct HierarchyStatistics {
  std::size_t nodes = 0;
  std::size_t faces = 0;  // 0: over the objects
  double surface_area_cost = 0;
};

struct Statistics {
  // The scene.
  std::size_t objects = 0, triangles = 0, lights = 0, textures = 0;
  SceneNeeds needs;
  std::vector<LeftOut> left_out;
  std::vector<CulledLight> culled_lights;
  bool everything_modelled = false;

  // What was done.
  InstructionSet instruction_set = InstructionSet::baseline;
  std::optional<HierarchyStatistics> hierarchy;
  int width = 0, height = 0;
  RayCounts rays;
  DecodedPictures decoded;

  // Stages. Decoding pictures is a part of Stage::load, beside those of `load`.
  StageClock clock;
  LoadTimes load;
  LoadSizes sizes;
  SceneBytes scene_bytes;
  std::size_t hierarchy_bytes = 0, picture_bytes = 0;
  std::optional<std::uint64_t> file_bytes;  // of the picture's file, where it is a file
  std::uint64_t peak_bytes = 0;             // the most memory that was resident

  // From description to scene without decoding pictures.
  double scene_milliseconds() const;
};

Statistics statistics_of(const StageClock& clock, const LoadedScene& loaded, const FileImages& images,
                         const SceneTree& tree, const RenderOptions& options, const Rendered& rendered,
                         const std::filesystem::path& output);

// For people; some lines each stand for a list.
std::string to_text(const Statistics& statistics);

// docs/schemas/stats-1.schema.json
std::string to_json(const Statistics& statistics);

}  // namespace trace
