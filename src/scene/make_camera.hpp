// The camera of all of a scene's camera blocks.
#pragma once

#include <optional>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/camera.hpp"
#include "scene/dialect_rules.hpp"

namespace trace {

class CameraMaker {
 public:
  explicit CameraMaker(parser::Diagnostics& diagnostics, const DialectRules& rules = {})
      : diagnostics_(diagnostics), rules_(rules) {}

  // Blocks in file order: what a later one gives replaces what earlier ones did.
  void add(const parser::Camera& block);

  // The camera looks at a point from where the last block has put it. An orthographic one without `height`
  // sees what its perspective would at distance 1.
  Camera take();

 private:
  void set_view(const Vec3& direction, const Vec3& up);

  parser::Diagnostics& diagnostics_;
  DialectRules rules_;
  Camera camera_;
  std::optional<parser::Vector3> look_at_, up_;  // where nothing later says which way to look
  bool orthographic_ = false;
  std::optional<parser::Scalar> height_;
};

}  // namespace trace
