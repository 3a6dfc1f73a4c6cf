// The examples of docs/language.md: each is a scene that is drawn without a complaint, and the picture beside
// it is its picture; each example of an error has the message that stands below it.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "image/image.hpp"
#include "image/image_source.hpp"
#include "loading/scene_loader.hpp"
#include "rendering/render.hpp"

namespace trace::test {
namespace {

namespace fs = std::filesystem;

const fs::path root = TRACE_SOURCE_DIR;

struct Example {
  std::string name, body;
  std::string message;  // of an error: the block behind it
};

std::string text_of_language() {
  std::ifstream file(root / "docs/language.md", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The blocks "```ray NAME"; behind "```ray error" the next block is its message.
std::vector<Example> examples() {
  std::istringstream lines(text_of_language());
  std::vector<Example> result;
  std::string line;
  const auto block = [&] {
    std::string body;
    while (std::getline(lines, line) && line != "```") body += line + "\n";
    return body;
  };
  while (std::getline(lines, line)) {
    if (line.rfind("```", 0) != 0) continue;
    const bool ray = line.rfind("```ray ", 0) == 0;
    const std::string name = ray ? line.substr(7) : "";
    const std::string body = block();
    if (ray) {
      result.push_back({name, body, {}});
    } else if (!result.empty() && result.back().name == "error" && result.back().message.empty()) {
      result.back().message = body;
    }
  }
  return result;
}

// Behind the frame of the document, without its lights where the example has one, unless it has its own
// header.
std::string scene_of(const Example& example, const std::string& frame) {
  if (example.body.rfind("SBT-raytracer", 0) == 0) return example.body;
  if (!std::regex_search(example.body, std::regex("_light\\b|warn_model"))) return frame + example.body;
  std::istringstream lines(frame);
  std::string line, kept;
  while (std::getline(lines, line)) {
    if (line.find("_light") == std::string::npos) kept += line + "\n";
  }
  return kept + example.body;
}

LoadedScene loaded(const std::string& name, const std::string& text) {
  FileImages images;
  return load_scene(parser::Source::from_text(name, text), 160, images);
}

// Relative names start from the scenes.
class InScenes {
 public:
  InScenes() : before_(fs::current_path()) { fs::current_path(root / "scenes"); }
  InScenes(const InScenes&) = delete;
  InScenes& operator=(const InScenes&) = delete;
  ~InScenes() {
    std::error_code error;
    fs::current_path(before_, error);
  }

 private:
  fs::path before_;
};

std::string frame_of(const std::vector<Example>& all) {
  for (const Example& example : all) {
    if (example.name == "frame") return example.body;
  }
  return {};
}

}  // namespace

TEST_CASE("each example of the language manual is drawn, and the picture beside it is its picture") {
  const InScenes folder;
  const std::vector<Example> all = examples();
  const std::string frame = frame_of(all), document = text_of_language();
  REQUIRE_FALSE(frame.empty());
  std::set<std::string> names;
  for (const Example& example : all) {
    if (example.name == "frame" || example.name == "error") continue;
    INFO(example.name);
    CHECK(names.insert(example.name).second);
    const LoadedScene scene = loaded(example.name, scene_of(example, frame));
    CHECK(scene.messages.empty());
    REQUIRE(scene.scene);
    RenderOptions options;
    options.width = 160;
    Progress progress;
    const Rendered picture = render(*scene.scene, SceneTree(*scene.scene), options, progress);
    const std::string link = "pictures/language/" + example.name + ".png";
    CHECK(document.find("](" + link + ")") != std::string::npos);
    const Image shown = read_image((root / "docs" / link).string());
    CHECK(picture.image.rgb == shown.rgb);
  }
  CHECK(names.size() > 40);
}

TEST_CASE("each example of an error in the language manual has the message below it") {
  const InScenes folder;
  const std::vector<Example> all = examples();
  const std::string frame = frame_of(all);
  std::size_t errors = 0;
  for (const Example& example : all) {
    if (example.name != "error") continue;
    INFO(example.body);
    const LoadedScene scene = loaded("scene.ray", "SBT-raytracer 1.0\n" + example.body);
    CHECK(scene.messages == example.message);
    ++errors;
  }
  CHECK(errors > 0);
}

}  // namespace trace::test
