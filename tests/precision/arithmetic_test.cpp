// What the arithmetic of rays loses.
#include <catch2/catch.hpp>

#include "scene/beyond_course.hpp"
#include "tests/precision/precision_pictures.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Against extended precision.
LevelErrors loss(Arithmetic arithmetic, const Scene& scene, const RenderOptions& options) {
  return level_errors(render_in(arithmetic, scene, options, 2),
                      render_in(Arithmetic::extended, scene, options, 2));
}

// Which is all of the picture.
Scene shaded_sphere() {
  Scene scene;
  scene.camera = usual_camera();
  scene.lights = {PointLight{Rgb(5), Vec3(1, 2, 12)}};
  add(scene, Sphere{}, moved(0.1, 0.2, 0.3) * scaled(8), diffuse(Rgb(0.7, 0.5, 0.3)));
  scene.camera.eye = {0, 0, 10};
  return scene;
}

// A ball that fills the picture, whatever its distance.
Scene ball_at(double distance) {
  Scene scene;
  scene.camera.window_height = 2.5 / distance;
  add(scene, Sphere{}, moved(0, 0, -distance), emissive(Rgb(0.75)));
  return scene;
}

Scene tilted_plane_at(double coordinate) {
  Scene scene;
  const Vec3 middle(coordinate, -0.7 * coordinate, 0.4 * coordinate);
  scene.camera.eye = middle + Vec3(0, 0, 4);
  scene.lights = {directional({-0.6, -0.5, -0.6})};
  add(scene, Square{}, moved(middle.x, middle.y, middle.z) * turned(0.5, 1, 0.3, 0) * scaled(50, 70, 1),
      diffuse(Rgb(0.9)));
  return scene;
}

}  // namespace

TEST_CASE("on a smooth surface a float loses 2^29 times what a double does, within a factor of 4") {
  const Scene scene = shaded_sphere();
  const double single = loss(Arithmetic::single, scene, of_width(64)).root_mean_square;
  const double working = loss(Arithmetic::working, scene, of_width(64)).root_mean_square;
  INFO(single << " and " << working << " levels: 2^" << std::log2(single / working));
  CHECK(single / working > 0x1p27);
  CHECK(single / working < 0x1p31);
  CHECK(single < 0.1);
  CHECK(working > 0);
}

TEST_CASE("where all numbers are exact all kinds of arithmetic give the same") {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, scaled(2, 2, 1), emissive(Rgb(0.5, 0.25, 0.125)));
  add(scene, Square{}, moved(-0.53, 0, 0.5), emissive(Rgb(0.75, 1, 0)));
  scene.ambient = Rgb(0.5);
  const auto in = [&](Arithmetic arithmetic) { return render_in(arithmetic, scene, of_width(40), 1).colors; };
  const auto extended = in(Arithmetic::extended);
  CHECK(in(Arithmetic::working) == extended);
  CHECK(in(Arithmetic::single) == extended);
  CHECK(extended.front() == 0.75);
  CHECK(extended.back() == 0.125);
}

TEST_CASE("two threads draw what one draws in every arithmetic") {
  const Scene scene = scene_of_file(precision_scenes / "features/nested_glass.ray", 48);
  for (const Arithmetic arithmetic : {Arithmetic::single, Arithmetic::working, Arithmetic::extended}) {
    const ArithmeticPicture one = render_in(arithmetic, scene, of_width(48), 1);
    const ArithmeticPicture two = render_in(arithmetic, scene, of_width(48), 2);
    CHECK(one.colors == two.colors);
    CHECK(one.rays.total() == two.rays.total());
    CHECK(one.seconds > 0);
  }
}

TEST_CASE("a ball 100000 units away is torn in floats and whole in doubles") {
  const Scene scene = ball_at(1e5);
  CHECK(loss(Arithmetic::single, scene, of_width(64)).over_a_level > 200);
  CHECK(loss(Arithmetic::working, scene, of_width(64)).over_a_level == 0);
  // Near, floats have it whole too.
  CHECK(loss(Arithmetic::single, ball_at(10), of_width(64)).over_a_level == 0);
}

TEST_CASE("a surface does not shade itself in floats, near or at coordinates of a thousand") {
  for (const double coordinate : {1.0, 1000.0}) {
    INFO(coordinate);
    const Scene scene = tilted_plane_at(coordinate);
    const ArithmeticPicture picture = render_in(Arithmetic::single, scene, of_width(64), 1);
    CHECK(*std::min_element(picture.colors.begin(), picture.colors.end()) > 0.25);
  }
}

TEST_CASE("no ray in floats is lost between the boxes of a fine mesh") {
  // A height field of 20000 triangles that fills the picture, far from the origin.
  constexpr std::uint32_t side = 101;
  Mesh mesh;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      mesh.points.push_back({x * 0.1, y * 0.1, 0.3 * std::sin(x * 0.37) * std::cos(y * 0.23)});
    }
  }
  for (std::uint32_t y = 0; y + 1 < side; ++y) {
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x;
      mesh.faces.push_back({a, a + 1, a + side});
      mesh.faces.push_back({a + 1, a + side + 1, a + side});
    }
  }
  for (const double coordinate : {0.0, 500.37}) {
    INFO(coordinate);
    const Vec3 offset(coordinate, 0.7 * coordinate, -0.4 * coordinate);
    Mesh placed = mesh;
    for (Vec3& p : placed.points) p += offset;
    const Mat4 place = turned(0.3, 0.3, 0.2, 1);
    Scene scene;
    scene.camera.eye = Vec3(place * Vec4(offset + Vec3(5, 5, 0), 1)) + Vec3(0, 0, 6);
    add(scene, placed, place, emissive(Rgb(1)));
    const RenderOptions options = of_width(128);
    const auto dark = [&](Arithmetic arithmetic) {
      const ArithmeticPicture picture = render_in(arithmetic, scene, options, 1);
      return std::count(picture.colors.begin(), picture.colors.end(), 0.0);
    };
    // Between neighbours a plain triangle test may let a ray pass, in floats one of ten thousand.
    CHECK(dark(Arithmetic::single) <= 3 * 4);
    CHECK(dark(Arithmetic::working) == 0);
  }
}

TEST_CASE("on the hard scenes the program is ten times nearer to extended precision than floats are") {
  for (const auto& [name, depth] : {std::pair("far_away", 5), {"thin_shell", 8}, {"mirror_balls", 14}}) {
    INFO(name);
    const Scene scene = scene_of_file(precision_scenes / "hard" / (std::string(name) + ".ray"), 96);
    const RenderOptions options = of_width(96, depth);
    const ArithmeticPicture truth = render_in(Arithmetic::extended, scene, options, 2);
    const LevelErrors single = level_errors(render_in(Arithmetic::single, scene, options, 2), truth);
    const LevelErrors program = level_errors(rendered(scene, options).image, truth);
    CHECK(single.root_mean_square > 2);
    CHECK(single.over_a_level > 20);
    CHECK(program.root_mean_square < single.root_mean_square / 10);
    CHECK(program.over_a_level <= 1);
  }
}

TEST_CASE("a scene that the plain tracer does not know is refused, not drawn otherwise") {
  const Shape shape =
      GENERATE(Shape(Sphere{}), Shape(Tube{}), Shape(Torus(1, 0.5)), Shape(Plane(Vec3(0), Vec3(0, 0, 1))),
               Shape(Quadric({1, 0, 0, 0, 0, 0, 0, 0, 0, -1})));
  Scene scene;
  scene.textures.emplace_back(Image{1, 1, {1, 2, 3}});
  add(scene, Sphere{}, at_origin(), diffuse(Rgb(1)));
  MappedMaterial map;
  map.diffuse = 0;
  add(scene, Box{}, at_origin(), map);
  CHECK(beyond_course(scene).empty());
  add(scene, shape, at_origin(), map);
  CHECK_FALSE(beyond_course(scene).empty());
  CHECK_THROWS_AS(render_in(Arithmetic::working, scene, of_width(2), 1), std::invalid_argument);
}
