// Marble and noise.
#include "scene/solid_pattern.hpp"
#include "scene/perlin_noise.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"
#include "tests/support/scene_random.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("noise is 0 at points with whole coordinates, bounded, and repeats after 256") {
  Random random(3);
  double least = 0, most = 0;
  for (int i = 0; i < 5'000; ++i) {
    const Vec3 p = random.in_cube(100);
    CHECK(perlin_noise(glm::floor(p)) == 0);
    const double n = perlin_noise(p);
    least = std::min(least, n);
    most = std::max(most, n);
    CHECK(perlin_noise(p + Vec3(256, -512, 0)) == Approx(n).margin(1e-9));
  }
  CHECK(least < -0.5);
  CHECK(least > -1.1);
  CHECK(most > 0.5);
  CHECK(most < 1.1);
  CHECK(perlin_noise({std::nan(""), 0, 0}) == 0);
  CHECK(std::abs(perlin_noise({1e300, -1e300, 0.5})) < 1.1);
}

TEST_CASE("noise has the value of Perlin's reference implementation at a point that others publish") {
  CHECK(perlin_noise({3.14, 42, 7}) == Approx(0.13691995878400012).epsilon(1e-12));
}

TEST_CASE("marble is as bright as its sine of the turbulent x, and never less than black") {
  SolidPattern marble;
  marble.color = {1, 0.5, 0.25};
  marble.lightness = 0.5;
  marble.frequency = 2;
  marble.contrast = 0;
  marble.depth = 3;
  const double bright = 0.5 + 0.5 * std::sin(2 * 0.3);
  CHECK(marble.at({0.3, 7, 9}) == near(bright * marble.color));
  marble.contrast = 0.8;
  const Vec3 p(0.3, 0.7, 0.9);
  const double turbulence = 1.75 * perlin_noise(p * Vec3(1, 2, 3));
  marble.scale = {1, 2, 3};
  CHECK(marble.at(p) == near((0.5 + 0.5 * std::sin(2 * (0.3 + 0.8 * turbulence))) * marble.color));
  marble.lightness = 0;
  for (int i = 0; i < 50; ++i) CHECK(marble.at({i * 0.37, 0, 0}).x >= 0);
}

TEST_CASE("noise makes grey by the sine of z and its turbulence") {
  SolidPattern noise;
  noise.kind = SolidPattern::Kind::perlin_noise;
  noise.scale = Vec3(4);
  noise.depth = 0;
  CHECK(noise.at({9, 9, 0.25}) == near(Rgb(0.5 * (1 + std::sin(1.0)))));
  noise.depth = 2;
  const Vec3 p(0.3, 0.6, 0.2);
  const double turbulence = std::abs(perlin_noise(p) + 0.5 * perlin_noise(2.0 * p));
  CHECK(noise.at(p) == near(Rgb(0.5 * (1 + std::sin(0.8 + 10 * turbulence)))));
}

TEST_CASE("a pattern is where the point is in the object's own space, on every kind of object") {
  const PrimitiveShape shape =
      GENERATE(PrimitiveShape(parser::Sphere{}), PrimitiveShape(parser::Box{}),
               PrimitiveShape(parser::Cylinder{}), PrimitiveShape(parser::MeshId{0}));
  parser::SolidTexture said;
  said.kind = parser::SolidTexture::Kind::perlin_noise;
  Describe d;
  d.scene.meshes.push_back(triangle_mesh());
  const auto object = d.element(primitive(shape, {block({{Parameter::emissive, said, {}, {}}})}));
  d.top(d.element(parser::Translate{{3, 0, 0}}, {d.element(parser::Scale{{2, 2, 2}}, {object})}));
  const Built built = build(d);
  REQUIRE_FALSE(built.diagnostics.has_errors());
  SolidPattern noise;
  noise.kind = SolidPattern::Kind::perlin_noise;
  noise.scale = Vec3(4);
  noise.depth = 7;
  const SceneTree tree(built.scene);
  const Ray ray{{3.2, 0.3, 8}, {0, 0, -1}};
  const Hit hit = tree.closest(ray, false);
  REQUIRE(hit);
  const Vec3 p = (ray.at(hit.t) - Vec3(3, 0, 0)) / 2.0;
  CHECK(seen(built.scene, ray) == near(noise.at(p), 1e-9));
}
