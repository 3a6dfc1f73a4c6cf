#include "tests/hostile/mutations.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace trace::test {
namespace {

constexpr std::array<std::string_view, 22> numbers{
    "0",     "-0",    "1",     "-1",    "1e308", "-1e308",     "1e-320", "4e-162",
    "1e999", "1e154", "0.5",   "1e-16", "1e16",  "4294967296", "3.5e38", "-.5",
    "nan",   "inf",   "1.2.3", "1e",    "0x10",  "65537"};

constexpr std::array<std::string_view, 54> words{
    "camera",     "point_light",    "sphere",        "box",         "square",       "cylinder",
    "cone",       "trimesh",        "translate",     "rotate",      "scale",        "transform",
    "material",   "map(\"a.png\")", "spot_light",    "area_light",  "fog",          "plane",
    "torus",      "quadric",        "paraboloid",    "hyperboloid", "torus_knot",   "height_field",
    "skybox",     "cubemap",        "look_at",       "projection",  "orthographic", "capped",
    "bump",       "marble",         "perlin_noise",  "texture_uv",  "objfile",      "diffuse",
    "reflective", "transmissive",   "index",         "shininess",   "aspectratio",  "fov",
    "true",       "name",           "points",        "faces",       "normals",      "materials",
    "gennormals", "metaball",       "SBT-raytracer", "\"",          "/*",           "//"};

class Mutator {
 public:
  Mutator(std::string text, const std::vector<std::string>& scenes, std::mt19937_64& random)
      : text_(std::move(text)), scenes_(scenes), random_(random) {}

  void mutate() {
    if (text_.empty()) return;
    switch (below(15)) {  // nearly half of them change numbers: those are read, and drawn
      case 0:
        text_[below(text_.size())] = static_cast<char>(below(256));
        break;
      case 1:
        text_[below(text_.size())] = "(){},=;\"/*.-e#\n"[below(15)];
        break;
      case 2:
        text_.erase(below(text_.size()), 1 + below(20));
        break;
      case 3: {
        const std::size_t at = below(text_.size());
        text_.insert(below(text_.size()), text_.substr(at, 1 + below(60)));
        break;
      }
      case 4:
        replace_run([](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; },
                    words[below(words.size())]);
        break;
      case 5: {
        const std::string& other = scenes_[below(scenes_.size())];
        if (!other.empty())
          text_.insert(below(text_.size()), other.substr(below(other.size()), 1 + below(400)));
        break;
      }
      case 6:
        if (below(4) == 0) text_.resize(below(text_.size()));
        break;
      case 7:
        text_.insert(below(text_.size()), words[below(words.size())]);
        break;
      default:
        replace_run(
            [](char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '-'; },
            numbers[below(numbers.size())]);
    }
  }

  std::string take() { return std::move(text_); }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  // The first run of such characters behind a random place.
  template <class Belongs>
  void replace_run(const Belongs& belongs, std::string_view with) {
    std::size_t begin = below(text_.size());
    while (begin < text_.size() && !belongs(text_[begin])) ++begin;
    std::size_t end = begin;
    while (end < text_.size() && belongs(text_[end])) ++end;
    text_.replace(begin, end - begin, with);
  }

  std::string text_;
  const std::vector<std::string>& scenes_;
  std::mt19937_64& random_;
};

}  // namespace

std::string mutated(const std::string& scene, const std::vector<std::string>& scenes,
                    std::mt19937_64& random) {
  Mutator mutator(scene, scenes, random);
  for (std::size_t changes = 1 + random() % 2 * (random() % 4); changes > 0; --changes) mutator.mutate();
  return mutator.take();
}

}  // namespace trace::test
