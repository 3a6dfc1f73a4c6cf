// Whole pictures with each set of instructions against those of single rays.
#include <catch2/catch.hpp>
#include <sstream>

#include "loading/scene_loader.hpp"
#include "loading/settings_file.hpp"
#include "rendering/render.hpp"
#include "tests/support/picture_table.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// A row of a manifest, at most so wide.
struct PictureJob {
  RenderOptions options;
  std::string cube_map;
};

PictureJob job_of(const std::filesystem::path& folder, const std::string& arguments, int max_width_here) {
  PictureJob job;
  std::istringstream words(arguments);
  for (std::string flag, value; words >> flag >> value;) {
    if (flag == "-r") job.options.depth = std::stoi(value);
    if (flag == "-w") job.options.width = std::stoi(value);
    if (flag == "-j") read_settings((folder / value).string()).apply(job.options);
    if (flag == "-c") job.cube_map = (folder / value).string();
  }
  job.options.width = std::min(job.options.width, max_width_here);
  job.options.threads = 1;
  job.options.shading.count_work = true;
  return job;
}

std::vector<InstructionSet> sets_here() {
  std::vector<InstructionSet> result;
  for (const auto set : {InstructionSet::sse4, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set <= best_instruction_set()) result.push_back(set);
  }
  return result;
}

// The picture that models everything is the same; and so are those of single rays and packets where faint
// rays are left out, and where everything is modelled.
void check_switches(const Scene& scene, const SceneTree& tree, const RenderOptions& options,
                    const Rendered& expected) {
  const auto rendered = [&](InstructionSet set, double least, bool everything) {
    RenderOptions o = options;
    o.instruction_set = set;
    o.shading.least_contribution = least;
    o.shading.model_everything = everything;
    Progress progress;
    return render(scene, tree, o, progress);
  };
  for (const bool everything : {false, true}) {
    const double least = everything ? 0 : 0.2;
    INFO("everything " << everything);
    const Rendered single = rendered(InstructionSet::baseline, least, everything);
    const Rendered packets = rendered(best_instruction_set(), least, everything);
    CHECK(packets.image.rgb == single.image.rgb);
    CHECK(packets.rays == single.rays);
    if (everything) CHECK(single.image.rgb == expected.image.rgb);
  }
}

// Renders a table's scenes every way; returns how many there are.
int check_table(const std::filesystem::path& folder, int width) {
  int pictures = 0;
  FileImages images;
  for (const auto& row : read_table(folder / "manifest.tsv")) {
    PictureJob job = job_of(folder, row[1], width);
    auto loaded = load_scene((folder / row[0]).string(), job.options.width, images);
    if (!loaded.scene) continue;  // some cases are about errors
    Scene& scene = *loaded.scene;
    if (!(picture_height(scene, job.options.width) >= 1)) continue;
    std::string problem;
    if (!job.cube_map.empty()) scene.cube_map = read_cube_map(job.cube_map, images, problem);
    ++pictures;
    const SceneTree tree(scene, 1);
    const auto rendered = [&](InstructionSet set, int threads) {
      RenderOptions options = job.options;
      options.instruction_set = set;
      options.threads = threads;
      Progress progress;
      return render(scene, tree, options, progress);
    };
    const Rendered expected = rendered(InstructionSet::baseline, 1);
    for (const InstructionSet set : sets_here()) {
      const Rendered found = rendered(set, set == InstructionSet::avx2 ? 2 : 1);
      INFO(row[0] << ' ' << row[1] << " with " << name_of(set));
      CHECK(found.image.rgb == expected.image.rgb);
      CHECK(found.rays == expected.rays);
      CHECK(found.non_finite.count == expected.non_finite.count);
    }
    const Rendered by_two = rendered(best_instruction_set(), 2);
    INFO(row[0] << ' ' << row[1] << " by two threads");
    CHECK(by_two.image.rgb == expected.image.rgb);
    CHECK(by_two.rays == expected.rays);
    check_switches(scene, tree, job.options, expected);
  }
  return pictures;
}

const std::filesystem::path source = TRACE_SOURCE_DIR;

}  // namespace

TEST_CASE("our scenes have the same pixels and rays with every set of instructions") {
  CHECK(check_table(source / "scenes", 40) >= 20);
}

TEST_CASE("the picture cases have the same pixels and rays with every set of instructions") {
  CHECK(check_table(source / "tests/picture_cases", 24) >= 250);
}
