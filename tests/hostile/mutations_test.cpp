// Whatever becomes of a scene, loading it ends in a picture or in errors with their places.
#include "tests/hostile/mutations.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "image/image_source.hpp"
#include "loading/scene_loader.hpp"
#include "rendering/render.hpp"

namespace trace::test {
namespace {

namespace fs = std::filesystem;

struct SceneText {
  std::string file, text;
};

// The scenes under a folder that are no longer than this, in the order of their names.
std::vector<SceneText> scenes_under(const fs::path& folder, std::uintmax_t longest) {
  std::vector<SceneText> scenes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".ray" || entry.file_size() > longest)
      continue;
    std::ifstream file(entry.path(), std::ios::binary);
    scenes.push_back({entry.path().string(), {std::istreambuf_iterator<char>(file), {}}});
  }
  std::sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return scenes;
}

struct Tally {
  std::size_t pictures = 0, refused = 0;
};

// Goes back to the folder there was.
class FolderGuard {
 public:
  FolderGuard() : before_(fs::current_path()) {}
  FolderGuard(const FolderGuard&) = delete;
  FolderGuard& operator=(const FolderGuard&) = delete;
  ~FolderGuard() {
    std::error_code error;
    fs::current_path(before_, error);
  }

 private:
  fs::path before_;
};

Tally draw_mutations(const std::vector<SceneText>& scenes, std::size_t count) {
  constexpr int width = 12, depth = 2;
  std::vector<std::string> texts;
  for (const SceneText& scene : scenes) texts.push_back(scene.text);
  std::mt19937_64 random(20001107);
  const FolderGuard guard;
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) {
    const SceneText& scene = scenes[i % scenes.size()];
    const std::string text = mutated(scene.text, texts, random);
    INFO(scene.file << ", mutation " << i << "\n" << text.substr(0, 4000));
    fs::current_path(fs::path(scene.file).parent_path());  // where a text's maps are looked for
    FileImages images;
    const LoadedScene loaded = load_scene(parser::Source::from_text(scene.file, text), width, images);
    if (!loaded.scene) {
      // "file:line:column: error: ..."
      const std::size_t error = loaded.messages.find(": error: ");
      REQUIRE(error != std::string::npos);
      const std::string place = loaded.messages.substr(0, error);
      REQUIRE(place.find(scene.file + ":") != std::string::npos);
      REQUIRE(std::isdigit(static_cast<unsigned char>(place.back())));
      ++tally.refused;
      continue;
    }
    if (picture_height(*loaded.scene, width) > 200) continue;
    RenderOptions options;
    options.width = width;
    options.depth = depth;
    options.threads = 1;
    Progress progress;
    const SceneTree tree(*loaded.scene, 1);
    const Rendered picture = render(*loaded.scene, tree, options, progress);
    REQUIRE(picture.image.width == width);
    ++tally.pictures;
  }
  return tally;
}

// How many are tried: TRACE_MUTATIONS, or else this.
std::size_t mutations(std::size_t usual) {
  const char* const asked = std::getenv("TRACE_MUTATIONS");
  return asked ? std::strtoul(asked, nullptr, 10) : usual;
}

constexpr std::uintmax_t longest = 100'000;

}  // namespace

TEST_CASE("each mutation of our scenes is a picture or errors with their places") {
  const Tally tally = draw_mutations(scenes_under(fs::path(TRACE_SOURCE_DIR) / "scenes", longest), 400);
  CHECK(tally.pictures > 0);
  CHECK(tally.refused > 0);
}

TEST_CASE("each mutation of the corpus' scenes is a picture or errors with their places") {
  const fs::path corpus = fs::path(TRACE_SOURCE_DIR) / "../shared/corpus";
  if (!fs::exists(corpus / "manifest.tsv")) {
    WARN("skipped: the corpus is not at ../shared/corpus");
    return;
  }
  const std::size_t count = mutations(600);
  const Tally tally = draw_mutations(scenes_under(corpus / "scenes", longest), count);
  WARN(count << " mutations: " << tally.pictures << " pictures, " << tally.refused << " refused");
  CHECK(tally.pictures > 0);
  CHECK(tally.refused > 0);
}

}  // namespace trace::test
