// The pinhole camera, and the one whose rays are parallel.
#pragma once

#include <optional>

#include "geometry/ray.hpp"

namespace trace {

// As the language leaves it: at the origin, looking along -z, and the window one unit high at distance one.
// set_view() uses the vectors as the scene gives them, neither normalised nor made orthogonal.
struct Camera {
  Vec3 eye{0};
  Vec3 look{0, 0, -1};
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  double window_height = 1;
  double aspect = 1;  // width / height
  // Where it is orthographic: the height of what it sees, and all of its rays go along `look` from the plane
  // through the eye. What is behind that plane is not seen.
  std::optional<double> orthographic_height;

  void set_fov(double degrees);  // vertical
  void set_view(const Vec3& direction, const Vec3& up_direction);
  // From the eye towards a point, upright: with the top of the picture towards +y, or +x where it looks along
  // the y axis. The point is not the eye.
  void set_look_at(const Vec3& point);
  // Unit vectors at right angles, in the plane of the two given; not finite where they do not span one.
  void set_orthonormal_view(const Vec3& direction, const Vec3& up_direction);
  void set_quaternion(const Vec4& q);  // x, y, z, w; not normalised

  // Rows of a picture that is `width` wide; not limited to what fits an int.
  double picture_height(int width) const { return width / aspect + 0.5; }
};

// The rays of one picture: (0, 0) is the lower left corner, (1, 1) the upper right.
class RayCaster {
 public:
  explicit RayCaster(const Camera& camera)
      : eye_(camera.eye),
        look_(camera.look),
        u_(camera.right * camera.window_height * camera.aspect),
        v_(camera.up * camera.window_height) {
    if (camera.orthographic_height) be_orthographic(camera, *camera.orthographic_height);
  }

  Ray cast(double x, double y) const { return cast(across(x), upward(y)); }

  // The two parts of a ray, for those who cast many along one column or row: their sum is its direction
  // before it is normalized or, of an orthographic camera, where it starts from the eye.
  Vec3 across(double x) const { return look_ + (x - 0.5) * u_; }
  Vec3 upward(double y) const { return (y - 0.5) * v_; }
  Ray cast(const Vec3& across, const Vec3& upward) const {
    if (parallel_) return {eye_ + (across + upward), *parallel_};
    return {eye_, glm::normalize(across + upward)};
  }

  // The direction of all rays of an orthographic camera.
  const std::optional<Vec3>& parallel() const { return parallel_; }

 private:
  void be_orthographic(const Camera& camera, double height);

  Vec3 eye_, look_, u_, v_;
  std::optional<Vec3> parallel_;
};

}  // namespace trace
