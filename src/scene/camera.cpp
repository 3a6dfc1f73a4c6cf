#include "scene/camera.hpp"

#include "geometry/unit_vector.hpp"

namespace trace {
namespace {

// As the course's renderer has it: its pictures show that the last digits are missing.
constexpr double course_pi = 3.14159265359;

}  // namespace

void Camera::set_fov(double degrees) {
  window_height = 2 * std::tan(degrees / (180 / course_pi) / 2);
}

void Camera::set_view(const Vec3& direction, const Vec3& up_direction) {
  look = direction;
  up = up_direction;
  right = glm::cross(up_direction, -direction);
}

void Camera::set_look_at(const Vec3& point) {
  const Vec3 direction = unit_vector(point - eye).direction;
  if (direction.x == 0 && direction.z == 0) return set_view(direction, Vec3(1, 0, 0));
  const Vec3 out = unit_vector(glm::cross(direction, Vec3(0, 1, 0))).direction;
  set_view(direction, glm::normalize(glm::cross(out, direction)));
}

void RayCaster::be_orthographic(const Camera& camera, double height) {
  parallel_ = unit_vector(camera.look).direction;
  look_ = Vec3(0);
  u_ = unit_vector(camera.right).direction * height * camera.aspect;
  v_ = unit_vector(camera.up).direction * height;
}

void Camera::set_orthonormal_view(const Vec3& direction, const Vec3& up_direction) {
  look = glm::normalize(direction);
  right = glm::normalize(glm::cross(look, up_direction));
  up = glm::cross(right, look);
}

void Camera::set_quaternion(const Vec4& q) {
  const double x = q.x, y = q.y, z = q.z, w = q.w;
  right = Vec3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (z * x - y * w));
  up = Vec3(2 * (x * y - z * w), 1 - 2 * (z * z + x * x), 2 * (y * z + x * w));
  look = -Vec3(2 * (z * x + y * w), 2 * (y * z - x * w), 1 - 2 * (y * y + x * x));
}

}  // namespace trace
