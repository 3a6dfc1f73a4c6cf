#include "scene/make_camera.hpp"

namespace trace {
namespace {

Vec3 vec3_of(const parser::Vector3& v) {
  return {v.value[0], v.value[1], v.value[2]};
}

}  // namespace

void CameraMaker::add(const parser::Camera& block) {
  if (block.position) camera_.eye = vec3_of(*block.position);
  if (block.fov) camera_.set_fov(block.fov->value);
  if (block.aspectratio) camera_.aspect = block.aspectratio->value;
  if (block.quaternion) {
    const auto& q = block.quaternion->value;
    camera_.set_quaternion(Vec4(q[0], q[1], q[2], q[3]));
    look_at_.reset();
  }
  if (block.viewdir && block.updir) {
    set_view(vec3_of(*block.viewdir), vec3_of(*block.updir));
    look_at_.reset();
  }
  if (block.look_at) {
    look_at_ = block.look_at;
    up_ = block.updir;
  }
  if (block.orthographic) orthographic_ = block.orthographic->value;
  if (block.height) height_ = block.height;
}

void CameraMaker::set_view(const Vec3& direction, const Vec3& up) {
  if (rules_.orthonormal_camera) {
    camera_.set_orthonormal_view(direction, up);
  } else {
    camera_.set_view(direction, up);
  }
}

Camera CameraMaker::take() {
  if (look_at_) {
    const Vec3 point = vec3_of(*look_at_);
    if (point == camera_.eye) {
      diagnostics_.error(look_at_->span, "'look_at' is where the camera is");
    } else {
      camera_.set_look_at(point);
      if (up_) set_view(camera_.look, vec3_of(*up_));
    }
  }
  if (height_ && !(height_->value > 0)) {
    diagnostics_.error(height_->span, "'height' must be greater than 0");
  } else if (height_ && !orthographic_) {
    diagnostics_.warning(height_->span, "'height' has no effect: the camera is not orthographic");
  }
  if (orthographic_) camera_.orthographic_height = height_ ? height_->value : camera_.window_height;
  return camera_;
}

}  // namespace trace
