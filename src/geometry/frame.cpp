#include "geometry/frame.hpp"

namespace trace {

Frame::Frame(const Mat4& placement)
    : to_world(placement),
      to_object(glm::inverse(placement)),
      normal_to_world(glm::transpose(glm::inverse(Mat3(placement)))) {}

bool Frame::invertible() const {
  for (int column = 0; column < 4; ++column) {
    if (!is_finite(Vec3(to_world[column])) || !is_finite(Vec3(to_object[column]))) return false;
  }
  return true;
}

}  // namespace trace
