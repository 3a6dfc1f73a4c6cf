#include "scene/camera.hpp"

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// The point of the window at distance one that the ray through (x, y) of the picture passes.
Vec3 on_window(const Camera& camera, double x, double y) {
  const Vec3 d = RayCaster(camera).cast(x, y).direction;
  return d / -d.z;
}

}  // namespace

TEST_CASE("without settings the camera looks along -z at a window one unit high at distance one") {
  const Camera camera;
  const Ray centre = RayCaster(camera).cast(0.5, 0.5);
  CHECK(centre.origin == Vec3(0));
  CHECK(centre.direction == Vec3(0, 0, -1));
  CHECK(on_window(camera, 0, 0) == near(-0.5, -0.5, -1));
  CHECK(on_window(camera, 1, 1) == near(0.5, 0.5, -1));
}

TEST_CASE("rays of the camera start at the eye and have unit length") {
  Camera camera;
  camera.eye = {1, 2, 3};
  camera.set_view({0, 0, -7}, {0, 3, 0});
  const Ray ray = RayCaster(camera).cast(0.1, 0.9);
  CHECK(ray.origin == Vec3(1, 2, 3));
  CHECK(glm::length(ray.direction) == about(1));
}

TEST_CASE("fov is the vertical angle of the window in degrees") {
  Camera camera;
  camera.set_fov(90);  // 2 tan 45 degrees
  CHECK(camera.window_height == Approx(2));
  CHECK(on_window(camera, 0.5, 1) == near(0, 1, -1, 1e-9));
  camera.set_fov(45);
  CHECK(camera.window_height == Approx(2 * (std::sqrt(2) - 1)));
  camera.set_fov(60);
  CHECK(camera.window_height == Approx(2 / std::sqrt(3)));
}

TEST_CASE("a fov beyond 180 turns the picture around") {
  Camera camera;
  camera.set_fov(270);  // 2 tan 135 degrees
  CHECK(camera.window_height == Approx(-2));
  CHECK(on_window(camera, 1, 1) == near(-1, -1, -1, 1e-9));
}

TEST_CASE("the aspect ratio widens the window and leaves its height") {
  Camera camera;
  camera.aspect = 2;
  CHECK(on_window(camera, 1, 1) == near(1, 0.5, -1));
}

TEST_CASE("a long view direction zooms in: nothing is normalised") {
  Camera camera;
  camera.set_view({0, 0, -3}, {0, 1, 0});
  // right = up x -look = (0,1,0) x (0,0,3) = (3,0,0), so only the height is magnified.
  CHECK(camera.right == Vec3(3, 0, 0));
  CHECK(on_window(camera, 0.5, 1) == near(0, 0.5 / 3, -1));
  CHECK(on_window(camera, 1, 0.5) == near(0.5, 0, -1));
}

TEST_CASE("an up direction that is not orthogonal to the view shears the picture: nothing is straightened") {
  Camera camera;
  camera.set_view({0, 0, -1}, {1, 2, 0});
  // right = (1,2,0) x (0,0,1) = (2,-1,0).
  CHECK(camera.right == Vec3(2, -1, 0));
  CHECK(camera.up == Vec3(1, 2, 0));
  CHECK(on_window(camera, 0.5, 1) == near(0.5, 1, -1));
  CHECK(on_window(camera, 1, 0.5) == near(1, -0.5, -1));
}

TEST_CASE("the usual view along +x has +z on its right") {
  Camera camera;
  camera.set_view({1, 0, 0}, {0, 1, 0});
  CHECK(camera.right == Vec3(0, 0, 1));
  CHECK(camera.look == Vec3(1, 0, 0));
}

TEST_CASE("a unit quaternion turns the camera") {
  Camera camera;
  const double half = std::sqrt(0.5);
  camera.set_quaternion({0, half, 0, half});  // a quarter turn about y: -z goes to -x, x to -z
  CHECK(camera.look == near(-1, 0, 0));
  CHECK(camera.right == near(0, 0, -1));
  CHECK(camera.up == near(0, 1, 0));
  camera.set_quaternion({half, 0, 0, half});  // about x: -z goes to y, y to z
  CHECK(camera.look == near(0, 1, 0));
  CHECK(camera.up == near(0, 0, 1));
  camera.set_quaternion({0, 0, half, half});  // about z: x goes to y
  CHECK(camera.right == near(0, 1, 0));
  CHECK(camera.up == near(-1, 0, 0));
}

TEST_CASE("a quaternion is not normalised") {
  Camera camera;
  camera.set_quaternion({1, 2, 3, 4});
  // Columns of [[1-2(yy+zz), 2(xy-zw), 2(zx+yw)], [2(xy+zw), 1-2(zz+xx), 2(yz-xw)], [2(zx-yw), 2(yz+xw),
  // 1-2(yy+xx)]].
  CHECK(camera.right == Vec3(-25, 28, -10));
  CHECK(camera.up == Vec3(-20, -19, 20));
  CHECK(camera.look == Vec3(-22, -4, 9));
}

TEST_CASE("a picture is its width over the aspect ratio high, rounded to the nearest") {
  Camera camera;
  camera.aspect = GENERATE(1.0, 1.7, 2.0, 0.5, 3.0);
  const int rows = camera.aspect == 1     ? 200
                   : camera.aspect == 1.7 ? 118
                   : camera.aspect == 2   ? 100
                   : camera.aspect == 0.5 ? 400
                                          : 67;
  CHECK(std::floor(camera.picture_height(200)) == rows);
}
