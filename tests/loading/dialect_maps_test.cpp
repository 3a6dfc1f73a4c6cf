// Maps, OBJ files and generated meshes from a scene's text to its picture.
#include "loading/scene_loader.hpp"
#include "precision/arithmetic.hpp"
#include "scene/beyond_course.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

LoadedScene loaded(const TemporaryFolder& folder, const std::string& text) {
  write_text(folder / "scene.ray", "SBT-raytracer 1.0\n" + text);
  FileImages images;
  return load_scene((folder / "scene.ray").string(), 64, images);
}

}  // namespace

TEST_CASE("texture_uv and map_points are where a mesh's points are on its maps") {
  const char* word = GENERATE("texture_uv", "map_points");
  const TemporaryFolder folder;
  write_image(folder / "bw.png", Image{2, 1, {0, 0, 0, 255, 255, 255}});
  const LoadedScene found = loaded(
      folder, "trimesh { points = ((-1,-1,0),(1,-1,0),(0,1,0)); faces = ((0,1,2));\n" + std::string(word) +
                  " = ((0,0),(1,0),(0.5,0)); material = { emissive = map(\"bw.png\"); } }\n");
  CHECK(found.messages == "");
  REQUIRE(found.scene);
  CHECK(seen(*found.scene) == near(0.5, 0.5, 0.5));
  CHECK_FALSE(beyond_course(*found.scene).empty());
}

TEST_CASE("an objfile is drawn in the mesh's material where its own is not there") {
  const TemporaryFolder folder;
  write_text(folder / "m.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
  const LoadedScene found =
      loaded(folder, "polymesh { objfile = \"m.obj\"; material = { emissive = (0, 0.5, 1); } }\n");
  CHECK(found.messages == "");
  REQUIRE(found.scene);
  CHECK(seen(*found.scene) == Rgb(0, 0.5, 1));
  const LoadedScene none = loaded(folder, "polymesh { objfile = \"n.obj\"; }\n");
  CHECK_FALSE(none.scene);
  CHECK_THAT(none.messages, Catch::Contains("scene.ray:2:22: error: cannot read 'n.obj': no such file"));
}

TEST_CASE("a torus knot and a sphere of noise load without a word, and are no core scene") {
  const TemporaryFolder folder;
  const LoadedScene knot = loaded(
      folder,
      "torus_knot { material = { emissive = (1,1,1); } radius = 1; tube = 0.15; p = 0.4; q = 3.5; }\n");
  CHECK(knot.messages == "");
  REQUIRE(knot.scene);
  CHECK(seen(*knot.scene, ray({1, 0.4, 5}, {0, 0, -1})) == Rgb(1));
  CHECK(seen(*knot.scene, ray({0, 5, 0}, {0, -1, 0})) == Rgb(0));  // through the hole
  const LoadedScene noise = loaded(
      folder,
      "sphere { material = { diffuse = (1,1,1); } perlin_noise = { scale = 4; turbulence_depth = 7; } }\n");
  CHECK(noise.messages == "");
  REQUIRE(noise.scene);
  CHECK_FALSE(beyond_course(*noise.scene).empty());
}
