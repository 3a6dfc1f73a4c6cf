// Cameras, lights and meshes of a description.
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"

using namespace trace;
using namespace trace::test;

namespace {

parser::Vector3 v(double x, double y, double z) {
  return {{x, y, z}, {}};
}

}  // namespace

TEST_CASE("camera blocks accumulate, the later one overriding") {
  Describe d;
  parser::Camera first, second;
  first.position = v(1, 2, 3);
  first.aspectratio = parser::Scalar{2, {}};
  second.position = v(4, 5, 6);
  second.fov = parser::Scalar{90, {}};
  d.top(first);
  d.top(second);
  const Camera camera = build(d).scene.camera;
  CHECK(camera.eye == Vec3(4, 5, 6));
  CHECK(camera.aspect == 2);
  CHECK(camera.window_height == Approx(2));
}

TEST_CASE("in one camera block the view direction goes before the quaternion") {
  Describe d;
  parser::Camera camera;
  camera.quaternion = parser::Vector4{{1, 2, 3, 4}, {}};
  if (GENERATE(false, true)) {
    camera.viewdir = v(1, 0, 0);
    camera.updir = v(0, 1, 0);
  }
  d.top(camera);
  CHECK(build(d).scene.camera.look == (camera.viewdir ? Vec3(1, 0, 0) : Vec3(-22, -4, 9)));
}

TEST_CASE("ambient lights add up") {
  Describe d;
  d.top(parser::AmbientLight{v(0.5, 0.5, 0.5), {}});
  d.top(parser::AmbientLight{v(0.1, 0.2, -1), {}});
  CHECK(build(d).scene.ambient == near(0.6, 0.7, -0.5));
}

TEST_CASE("a directional light shines along its direction, of any length") {
  Describe d;
  d.top(parser::DirectionalLight{v(0, -3, -4), v(1, 2, 3), {}});
  const Scene scene = build(d).scene;
  REQUIRE(scene.lights.size() == 1);
  const auto& light = std::get<DirectionalLight>(scene.lights[0]);
  CHECK(light.towards == near(0, 0.6, 0.8));
  CHECK(light.color == Rgb(1, 2, 3));
}

TEST_CASE("a scene knows whether transmission leaves the range that keeps shadows finite") {
  const double kt = GENERATE(0.0, 0.5, 1.0, 1.5, -0.5);
  Describe d;
  d.top(primitive(parser::Sphere{}, {block({is(Parameter::transmissive, 1, kt, 0)})}));
  CHECK(build(d).scene.shadow_may_be_undefined == (kt < 0 || kt > 1));
}

TEST_CASE("a point light keeps its given coefficients as 32-bit numbers and defaults to 1 / s^2") {
  Describe d;
  parser::PointLight light{v(1, 2, 3), v(1, 1, 1), {}, {}, {}, {}};
  d.top(light);
  light.constant = parser::Scalar{0.1, {}};
  light.linear = parser::Scalar{0.2, {}};
  light.quadratic = parser::Scalar{0.3, {}};
  d.top(light);
  const Scene scene = build(d).scene;
  const auto& plain = std::get<PointLight>(scene.lights.at(0));
  CHECK(plain.position == Vec3(1, 2, 3));
  CHECK((plain.constant == 0 && plain.linear == 0 && plain.quadratic == 1));
  const auto& given = std::get<PointLight>(scene.lights.at(1));
  CHECK((given.constant == 0.1f && given.linear == 0.2f && given.quadratic == 0.3f));
}

TEST_CASE("a cone that says nothing is pointed, of radius and height one, and capped") {
  Describe d;
  d.top(primitive(parser::Cone{}));
  const Built built = build(d);
  const auto& cone = std::get<Cone>(built.scene.objects.at(0).shape);
  LocalHit hit;
  // Down at x = 0.5: the side at z = 0.5 (within the tip's 1e-4); from below the cap at z = 0.
  REQUIRE(cone.intersect({{0.5, 0, 5}, {0, 0, -1}}, hit));
  CHECK(hit.t == Approx(4.5).epsilon(1e-4));
  REQUIRE(cone.intersect({{0.5, 0, -5}, {0, 0, 1}}, hit));
  CHECK(hit.t == 5);
}

TEST_CASE("the attributes of a cone are used") {
  parser::Cone said;
  said.bottom_radius = parser::Scalar{2, {}};
  said.top_radius = parser::Scalar{1, {}};
  said.height = parser::Scalar{3, {}};
  said.capped = parser::Located<bool>{false, {}};
  Describe d;
  d.top(primitive(said));
  const Built built = build(d);
  const Object& object = built.scene.objects.at(0);
  CHECK(object.bounds.min == Vec3(-2, -2, 0));
  CHECK(object.bounds.max == Vec3(2, 2, 3));
  LocalHit hit;
  // From below at x = 1.5 to the side (radius 1.5 at z = 1.5), not to a cap.
  REQUIRE(std::get<Cone>(object.shape).intersect({{1.5, 0, -5}, {0, 0, 1}}, hit));
  CHECK(hit.t == about(6.5));
}

TEST_CASE("a mesh of triangles and one with larger faces are built to the same fans") {
  parser::Mesh quadrilateral;
  quadrilateral.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  parser::Mesh triangles = quadrilateral;
  quadrilateral.corners = {0, 1, 2, 3, 0, 1, 3};
  quadrilateral.face_sizes = {4, 3};
  triangles.corners = {0, 1, 2, 0, 2, 3, 0, 1, 3};
  Describe d;
  d.top(d.mesh(quadrilateral));
  d.top(d.mesh(triangles));
  const Scene scene = build(d).scene;
  const std::vector<FaceCorners> faces{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}};
  CHECK(scene.meshes.at(0).geometry.faces == faces);
  CHECK(scene.meshes.at(1).geometry.faces == faces);
  CHECK(scene.triangle_count() == 6);
}

TEST_CASE("normals of a mesh are kept as given, or generated where the mesh says so") {
  parser::Mesh mesh = triangle_mesh();
  Describe flat, given, generated, both;
  flat.top(flat.mesh(mesh));
  CHECK_FALSE(build(flat).scene.meshes.at(0).geometry.smooth());
  mesh.generate_normals = true;
  generated.top(generated.mesh(mesh));
  CHECK(build(generated).scene.meshes.at(0).geometry.normals.at(1) == near(0, 0, 1));
  mesh.normals = {1, 0, 0, 0, 2, 0, 0, 0, 3};
  both.top(both.mesh(mesh));
  CHECK(build(both).scene.meshes.at(0).geometry.normals.at(1) == near(0, 2, 1));
  mesh.generate_normals = false;
  given.top(given.mesh(mesh));
  CHECK(build(given).scene.meshes.at(0).geometry.normals.at(1) == Vec3(0, 2, 0));
}
