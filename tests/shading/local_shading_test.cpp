// docs/language.md section 7 on a unit square in the plane z = 0 seen from the front, unless said.
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Rgb kd(0.8, 0.6, 0.4);

Scene square(const Material& material) {
  Scene scene;
  add(scene, Square{}, at_origin(), material);
  return scene;
}

Rgb lit(const Material& material, const Light& light, const ShadingOptions& options = {}) {
  Scene scene = square(material);
  scene.lights.push_back(light);
  return seen(scene, 0, options);
}

}  // namespace

TEST_CASE("a surface shows its emission without any light, once however many lights there are") {
  Scene scene = square(emissive({0.2, 0.1, 0.3}));
  CHECK(seen(scene) == near(0.2, 0.1, 0.3));
  scene.lights = {directional({0, 0, -1}), directional({0, 0, -1})};
  CHECK(seen(scene) == near(0.2, 0.1, 0.3));
}

TEST_CASE("ambient light is the sum of the ambient lights times the ambient colour, and nothing else") {
  Scene scene = square(ambient(kd));
  scene.lights = {directional({0, 0, -1})};
  CHECK(seen(scene) == Rgb(0));
  scene.ambient = Rgb(0.6, 0.7, 0.8);
  CHECK(seen(scene) == near(0.48, 0.42, 0.32));
}

TEST_CASE("diffuse light goes by the cosine of its angle and by the light's colour") {
  CHECK(lit(diffuse(kd), directional({0, 0, -5})) == near(kd));
  CHECK(lit(diffuse(kd), directional({1, 0, -1})) == near(kd * std::sqrt(0.5)));
  CHECK(lit(diffuse(kd), directional({0, 0, -1}, {0.5, 0.25, 1})) == near(0.4, 0.15, 0.4));
  CHECK(lit(diffuse(kd), directional({1, 0, 0})) == near(Vec3(0)));
}

TEST_CASE("lights add up, negative ones too") {
  Scene scene = square(diffuse(kd));
  scene.lights = {directional({0, 0, -1}, {-1, 0.5, 0.5}), directional({0, 0, -1})};
  CHECK(seen(scene) == near(0, 0.9, 0.6));
}

TEST_CASE(
    "a light behind an opaque surface gives no diffuse light, behind a transmissive one as much as before "
    "it") {
  CHECK(lit(diffuse(kd), directional({0, 0, 1})) == near(Vec3(0)));
  CHECK(lit(diffuse(kd) + transmissive({0.5, 0, 0}), directional({0, 0, 1})) == near(kd));
  CHECK(lit(diffuse(kd) + transmissive({0.5, 0, 0}), directional({1, 0, 1})) == near(kd * std::sqrt(0.5)));
}

TEST_CASE(
    "the highlight goes by the cosine between the light's reflection and the viewer, to the shininess") {
  // R.V = cos = 1 / sqrt(1.09) for the light along (0.3, 0, -1).
  const double cosine = 1 / std::sqrt(1.09);
  const double shininess = GENERATE(1.0, 10.0, 25.6);
  CHECK(lit(specular(kd, shininess), directional({0.3, 0, -1})) ==
        near(kd * std::pow(cosine, shininess), 1e-9));
}

TEST_CASE("without shininess the specular colour is added flatly wherever the light reaches") {
  CHECK(lit(specular(kd, 0), directional({0.3, 0, -1})) == near(kd));
  // R.V < 0 becomes 0, and 0^0 is 1: a light from the side, 75 degrees off, mirrored away from a slanting
  // viewer.
  Scene scene = square(specular(kd, 0));
  scene.lights = {directional({std::sin(1.3), 0, -std::cos(1.3)})};
  const Ray slanting = ray({std::sin(-1.3) * 5, 0, 5 * std::cos(1.3)}, {std::sin(1.3), 0, -std::cos(1.3)});
  CHECK(seen(scene, slanting) == near(kd));
  scene.materials[0].values.shininess = Rgb(1);
  CHECK(seen(scene, slanting) == near(Vec3(0)));
}

TEST_CASE("the highlight of a light behind the surface is that of light going straight through") {
  // R = -L for N.L < 0. A square seen from the front, with nothing to shadow it but itself.
  const double cosine = 1 / std::sqrt(1.09);
  CHECK(lit(specular(kd, 1), directional({0.3, 0, 1})) == near(kd * cosine));
  CHECK(lit(specular(kd, 1) + transmissive(Rgb(0.5)), directional({0.3, 0, 1})) == near(kd * cosine));
}

TEST_CASE("with backface_specular a transmissive surface mirrors light from behind to the front") {
  // N = z, L = (-0.6, 0, -0.8): 2 |N.L| N - L = (0.6, 0, 2.4), R.V = 2.4 / sqrt(6.12).
  ShadingOptions options;
  options.backface_specular = true;
  const DirectionalLight light = directional({0.6, 0, 0.8});
  CHECK(lit(specular(kd, 1) + transmissive(Rgb(0.5)), light, options) == near(kd * (2.4 / std::sqrt(6.12))));
  CHECK(lit(specular(kd, 1), light, options) == near(kd * 0.8));  // opaque: R = -L as ever
  // A light before the surface is not changed.
  CHECK(lit(specular(kd, 1) + transmissive(Rgb(0.5)), directional({0.6, 0, -0.8}), options) ==
        near(kd * 0.8));
}

TEST_CASE("an opaque surface seen from its back has only emission and ambient light") {
  const Material m =
      emissive(Rgb(0.1)) + ambient({0, 0, 0.1}) + diffuse({0.5, 0, 0}) + specular({0, 0.3, 0}, 1);
  Scene scene;
  add(scene, Sphere{}, at_origin(), m);
  scene.ambient = Rgb(1);
  scene.lights = {directional({0, 0, 1}), directional({0, 0, -1})};
  ShadingOptions options;
  options.shadows = false;
  CHECK(seen(scene, {Vec3(0), Vec3(0, 0, -1)}, 0, options) == near(0.1, 0.1, 0.2));
}

TEST_CASE("a transmissive surface seen from its back is shaded with its normal turned to the viewer") {
  // back_sphere6: 0.1 + (0.5, 0, 0) + (0, 0.3, 0) + (0, 0, 0.1) = (0.6, 0.4, 0.2).
  const Material m =
      emissive(Rgb(0.1)) + ambient({0, 0, 0.1}) + diffuse({0.5, 0, 0}) + specular({0, 0.3, 0}, 1);
  Scene scene;
  add(scene, Sphere{}, at_origin(), m + transmissive(Rgb(0.5)));
  scene.ambient = Rgb(1);
  scene.lights = {directional({0, 0, 1})};
  ShadingOptions options;
  options.shadows = false;
  CHECK(seen(scene, {Vec3(0), Vec3(0, 0, -1)}, 0, options) == near(0.6, 0.4, 0.2));
}

TEST_CASE("a point light is attenuated by its distance from the surface") {
  PointLight light{Rgb(1), Vec3(0, 0, 2)};
  CHECK(lit(diffuse(kd), light) == near(kd / 4.0));
  light.constant = 0.5f;
  CHECK(lit(diffuse(kd), light) == near(kd / 4.5));
  light.position.z = 0.5;
  light.constant = 0;
  CHECK(lit(diffuse(kd), light) == near(kd));
}

TEST_CASE("a surface on which the light falls from the side is lit at the cosine of that place") {
  // Light (3, 0, 4) over the origin: s = 5, cos = 4/5.
  CHECK(lit(diffuse(kd), PointLight{Rgb(1), Vec3(3, 0, 4)}) == near(kd * 0.8 / 25.0));
}

TEST_CASE("a light without a direction, or in the very surface, adds nothing") {
  Scene scene = square(emissive(Rgb(0.25)) + diffuse(kd));
  scene.lights = {directional({0, 0, 0}), PointLight{Rgb(1), Vec3(0)}};
  CHECK(seen(scene) == near(Vec3(0.25)));
}

TEST_CASE("smooth shading can be switched off, and materials of points are mixed all the same") {
  Scene scene;
  Mesh mesh = front_triangle();
  mesh.normals = std::vector<Vec3>(3, Vec3(std::sin(pi / 3), 0, std::cos(pi / 3)));
  add(scene, mesh, at_origin(), Material{}, {diffuse({1, 0, 0}), diffuse({0, 1, 0}), diffuse({0, 0, 1})});
  scene.lights = {directional({0, 0, -1})};
  // The point (0, 0, 0) of (-1,-1) (1,-1) (0,1): weights 1/4, 1/4, 1/2.
  CHECK(seen(scene) == near(0.125, 0.125, 0.25));
  ShadingOptions flat;
  flat.smooth_shading = false;
  CHECK(seen(scene, 0, flat) == near(0.25, 0.25, 0.5));
}

TEST_CASE(
    "a surface whose vertex normals cancel has only emission and ambient light there, and sends no rays on") {
  Scene scene;
  Mesh mesh = front_triangle();
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}};
  add(scene, mesh, at_origin(),
      emissive(Rgb(0.25)) + diffuse(Rgb(0.5)) + reflective(Rgb(1)) + transmissive(Rgb(1)));
  scene.lights = {directional({0, 0, -1})};
  const Traced cancelled = traced(scene, from_front(), 3);
  CHECK(cancelled.color == near(Vec3(0.25)));
  CHECK(cancelled.rays.total() == 1);
  // Lower down they do not cancel and point along z.
  CHECK(seen(scene, ray({0.25, -0.5, 5}, {0, 0, -1})) == near(Vec3(0.75)));
}

TEST_CASE("a texture on a square is seen the right way round from its front") {
  Scene scene;
  MappedMaterial material;
  material.emissive = 0;
  scene.textures.emplace_back(Image{2, 2, {0, 255, 0, 255, 255, 0, 0, 0, 0, 255, 0, 0}});  // u red, v green
  add(scene, Square{}, at_origin(), material);
  CHECK(seen(scene, ray({0.3, -0.1, 5}, {0, 0, -1})) == near(0.8, 0.4, 0));
}
