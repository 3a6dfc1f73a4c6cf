// Which file a name means, what becomes of one that is not there, and pictures over one another.
#include "scene/material_maps.hpp"
#include "scene/scene_files.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"

using namespace trace;
using namespace trace::test;

namespace {

parser::MaterialAssignment is_file(Parameter parameter, parser::MapFile map) {
  return {parameter, std::move(map), {10, 30}, {20, 30}};
}

// A folder with "deep/er/red.png" and "grey.png" (2 x 1: 51, 153).
class NestedFolder {
 public:
  NestedFolder() {
    std::filesystem::create_directories(directory_ / "deep/er");
    write_image(directory_ / "deep/er/red.png", Image{1, 1, {255, 0, 0}});
    write_image(directory_ / "grey.png", Image{2, 1, {51, 51, 51, 153, 153, 153}});
  }
  std::string path() const { return directory_.path().string(); }

 private:
  TemporaryFolder directory_;
};

Built square_of(const NestedFolder& folder, std::vector<parser::MaterialAssignment> assignments) {
  Describe d;
  d.top(block({is(Parameter::diffuse, 0.5, 0.25, 0.125)}));
  d.top(primitive(parser::Square{}, {block(std::move(assignments))}));
  return build(d, folder.path());
}

Rgb diffuse_of(const Built& built, const Vec2& uv = {0, 0}) {
  return at_point(built.scene.materials[built.scene.objects[0].material], built.scene.textures, uv).diffuse;
}

}  // namespace

TEST_CASE("a name with Windows separators is found with slashes") {
  const NestedFolder folder;
  const Built built = square_of(folder, {is_map(Parameter::diffuse, "deep\\er\\red.png")});
  REQUIRE_FALSE(built.diagnostics.has_errors());
  CHECK(diffuse_of(built) == Rgb(1, 0, 0));
}

TEST_CASE("a bare name is found without its leading folders where it is not as written; map() is not") {
  const NestedFolder folder;
  for (const char* name : {"red.png", "./deep/er/red.png", "./simpleSamples/bonus/deep/er/red.png",
                           "C:\\Users\\me\\deep\\er\\red.png"}) {
    INFO(name);
    const Built built = square_of(folder, {is_file(Parameter::diffuse, {name, true})});
    CHECK(built.diagnostics.all().empty() == (std::string(name) != "red.png"));
    if (built.diagnostics.all().empty()) CHECK(diffuse_of(built) == Rgb(1, 0, 0));
  }
  const Built map = square_of(folder, {is_map(Parameter::diffuse, "x/deep/er/red.png")});
  REQUIRE(map.diagnostics.error_count() == 1);
}

TEST_CASE("a bare name of a file that is not there is a warning, and the parameter stays as inherited") {
  const NestedFolder folder;
  const Built built = square_of(folder, {is_file(Parameter::diffuse, {"nope.bmp", true}),
                                         is_file(Parameter::ambient, {"nope.bmp", true})});
  REQUIRE(built.diagnostics.all().size() == 1);
  const parser::Diagnostic& warning = built.diagnostics.all()[0];
  CHECK(warning.severity == parser::Severity::warning);
  CHECK(warning.text == "cannot read texture 'nope.bmp': no such file: this map is left out");
  CHECK(warning.span.begin == 20);
  CHECK(diffuse_of(built) == Rgb(0.5, 0.25, 0.125));
}

TEST_CASE("maps beside a material apply on top of it") {
  const NestedFolder folder;
  parser::Primitive box = primitive(parser::Box{}, {block({is(Parameter::diffuse, 0, 0, 1)})});
  box.maps = {is_file(Parameter::diffuse, {"deep/er/red.png", true})};
  parser::Primitive other = primitive(parser::Box{});
  other.maps = {is_file(Parameter::bump, {"grey.png", true})};
  Describe d;
  d.top(box);
  d.top(other);
  const Built built = build(d, folder.path());
  CHECK(diffuse_of(built) == Rgb(1, 0, 0));
  CHECK(built.scene.materials[built.scene.objects[1].material].bump == 1);
}

TEST_CASE("a second picture lies over the first as far as it is brighter than the threshold") {
  const NestedFolder folder;
  // Luminance 0.2 and 0.6; above 0.5 the second counts by (luminance - 0.5) / 0.5.
  const Built built =
      square_of(folder, {is_file(Parameter::diffuse, {"deep/er/red.png", false, "grey.png", 0.5})});
  REQUIRE_FALSE(built.diagnostics.has_errors());
  CHECK(diffuse_of(built, {0, 0}) == Rgb(1, 0, 0));
  CHECK(diffuse_of(built, {1, 0}) == near(0.8 + 0.2 * 0.6, 0.2 * 0.6, 0.2 * 0.6));
  const Built all =
      square_of(folder, {is_file(Parameter::diffuse, {"deep/er/red.png", false, "grey.png", -10})});
  CHECK(diffuse_of(all, {1, 0}) == near(1 - 10.6 / 11 + 10.6 / 11 * 0.6, 10.6 / 11 * 0.6, 10.6 / 11 * 0.6));
}

TEST_CASE("a threshold of one or more is an error") {
  const NestedFolder folder;
  const Built built =
      square_of(folder, {is_file(Parameter::diffuse, {"deep/er/red.png", false, "grey.png", 1})});
  REQUIRE(built.diagnostics.error_count() == 1);
  CHECK(built.diagnostics.all()[0].text ==
        "the threshold 1 is not less than 1: nothing of 'grey.png' would be seen");
}

TEST_CASE("a map of anisotropic highlights is a warning") {
  const NestedFolder folder;
  const Built built = square_of(folder, {is_file(Parameter::anisotropy, {"nope.bmp", true})});
  REQUIRE(built.diagnostics.all().size() == 1);
  CHECK(built.diagnostics.all()[0].text == "a map of anisotropic highlights has no effect: they stay round");
}

TEST_CASE("a map may be a JPEG") {
  const NestedFolder folder;
  write_image(folder.path() + "/even.jpg", Image{8, 8, std::vector<std::uint8_t>(192, 128)});
  const Built built = square_of(folder, {is_map(Parameter::diffuse, "even.jpg")});
  REQUIRE_FALSE(built.diagnostics.has_errors());
  CHECK(diffuse_of(built) == near(Rgb(128 / 255.0), 0.02));
}
