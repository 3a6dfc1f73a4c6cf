// Pictures on meshes that say where their points are on them.
#include "scene/surface_maps.hpp"
#include "shading/surface.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// 2 x 1: black, white.
class BlackAndWhite {
 public:
  BlackAndWhite() { write_image(directory_ / "bw.png", Image{2, 1, {0, 0, 0, 255, 255, 255}}); }
  std::string path() const { return directory_.path().string(); }

 private:
  TemporaryFolder directory_;
};

Built mapped_mesh(const BlackAndWhite& folder, std::vector<double> coordinates) {
  parser::Mesh mesh = triangle_mesh();
  mesh.texture_coordinates = std::move(coordinates);
  Describe d;
  d.top(d.mesh(std::move(mesh), {block({is_map(Parameter::emissive, "bw.png")})}));
  return build(d, folder.path());
}

// At a place of the triangle (-1,-1,0) (1,-1,0) (0,1,0).
Rgb at_place(const Built& built, double x, double y) {
  return trace::test::seen(built.scene, ray({x, y, 5}, {0, 0, -1}));
}

}  // namespace

TEST_CASE("a mesh with texture coordinates shows its map at them, one without its lower left texel") {
  const BlackAndWhite folder;
  const Built with = mapped_mesh(folder, {0, 0, 1, 0, 0.5, 0});
  REQUIRE_FALSE(with.diagnostics.has_errors());
  CHECK(at_place(with, 0, 0) == near(0.5, 0.5, 0.5));
  CHECK(at_place(with, -0.25, 0) == near(0.375, 0.375, 0.375));
  CHECK(at_place(with, 0.25, -0.5) == near(0.625, 0.625, 0.625));
  const Built without = mapped_mesh(folder, {});
  CHECK(at_place(without, 0.25, -0.5) == Rgb(0));
}

TEST_CASE("texture coordinates beyond 1 repeat, and 1 itself is the far edge") {
  CHECK(repeated({0.25, 1}) == Vec2(0.25, 1));
  CHECK(repeated({1.25, -0.25}) == Vec2(0.25, 0.75));
  CHECK(repeated({2, -3}) == Vec2(0, 0));
  CHECK(repeated({std::numeric_limits<double>::infinity(), 0.5}) == Vec2(0));
  CHECK(repeated({std::nan(""), 0.5}) == Vec2(0));
  const BlackAndWhite folder;
  const Built wide = mapped_mesh(folder, {2.25, 0, 2.25, 7, 2.25, -3});
  CHECK(at_place(wide, 0.1, 0) == near(0.25, 0.25, 0.25));
}

TEST_CASE("materials of points take their maps at the texture coordinates of the points") {
  const BlackAndWhite folder;
  const auto map = block({is_map(Parameter::emissive, "bw.png")});
  parser::Mesh mesh = triangle_mesh({map, map, map});
  mesh.texture_coordinates = {0, 0, 1, 0, 0.5, 0};
  Describe d;
  d.top(d.mesh(std::move(mesh)));
  const Built built = build(d, folder.path());
  REQUIRE(built.scene.meshes[0].materials.size() == 3);
  CHECK(built.scene.meshes[0].materials[1].emissive == Rgb(1));
  CHECK(at_place(built, 0, 0) == near(0.5, 0.5, 0.5));
}
