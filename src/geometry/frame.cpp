#include "geometry/frame.hpp"

namespace trace {

Frame::Frame(const Mat4& placement)
    : to_world(placement),
      to_object(glm::inverse(placement)),
      normal_to_world(glm::transpose(glm::inverse(Mat3(placement)))) {
  const auto stretch = [](const Mat4& m) {
    double most = 0;
    for (int row = 0; row < 3; ++row) {
      most = std::max(most, std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]));
    }
    return most;
  };
  to_object_stretch = stretch(to_object);
  to_world_stretch = stretch(to_world);
  if (to_world != Mat4(1)) {
    relative_error_ = gamma(16) * to_object_stretch;
    error_at_origin_ = gamma(16) * largest(Vec3(to_object[3]));
  }
}

bool Frame::invertible() const {
  for (int column = 0; column < 4; ++column) {
    if (!is_finite(Vec3(to_world[column])) || !is_finite(Vec3(to_object[column]))) return false;
  }
  return true;
}

}  // namespace trace
