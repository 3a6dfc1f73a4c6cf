// The parts of Builder that read cameras and lights.
#include <fmt/format.h>

#include <utility>

#include "parser/builder.hpp"

namespace trace::parser {

namespace {

constexpr std::array<std::string_view, 3> vector_words{"position", "direction", "color"};
constexpr std::array<std::string_view, 3> attenuation_words{
    "constant_attenuation_coeff", "linear_attenuation_coeff", "quadratic_attenuation_coeff"};

}  // namespace

void Builder::begin_camera() {
  camera_ = {};
  errors_before_ = diagnostics_.error_count();
}

void Builder::viewdir(Vector3 value, Span word) {
  camera_.viewdir = value;
  viewdir_word_ = word;
}

void Builder::updir(Vector3 value, Span word) {
  camera_.updir = value;
  updir_word_ = word;
}

void Builder::aspectratio(Scalar value) {
  camera_.aspectratio = value;
  if (value.value > 0) return;
  diagnostics_.error(value.span, "'aspectratio' must be greater than 0");
}

void Builder::end_camera(Span span) {
  camera_.span = span;
  if (!errors_since_begin() && camera_.viewdir && !camera_.updir) {
    diagnostics_.error(viewdir_word_, "the camera gives 'viewdir' without 'updir'");
  }
  if (!errors_since_begin() && camera_.updir && !camera_.viewdir) {
    diagnostics_.error(updir_word_, "the camera gives 'updir' without 'viewdir'");
  }
  add_item(camera_);
}

void Builder::begin_light(std::string_view word, Span keyword) {
  light_ = {};
  light_.word = word;
  light_.keyword = keyword;
  errors_before_ = diagnostics_.error_count();
}

void Builder::given_twice(std::string_view attribute, Span first, Span again) {
  diagnostics_.error(again, fmt::format("'{}' is given twice in this {}", attribute, light_.word))
      .notes.push_back({first, "first given here"});
}

void Builder::light_vector(LightVector which, Vector3 value, Span word) {
  const auto number = static_cast<std::size_t>(which);
  Given& given = light_.vectors[number];
  if (given.value) return given_twice(vector_words[number], given.word, word);
  given = {value, word};
}

void Builder::attenuation(Attenuation which, Scalar value, Span word) {
  const auto number = static_cast<std::size_t>(which);
  if (light_.attenuation[number])
    return given_twice(attenuation_words[number], light_.attenuation_words[number], word);
  light_.attenuation[number] = value;
  light_.attenuation_words[number] = word;
}

// Where the block had errors, the attribute may be among what was passed over: nothing more is said.
bool Builder::require(LightVector which) {
  const auto number = static_cast<std::size_t>(which);
  if (light_.vectors[number].value) return true;
  if (!errors_since_begin()) {
    diagnostics_.error(light_.keyword, fmt::format("{} has no '{}'", light_.word, vector_words[number]));
  }
  return false;
}

void Builder::end_ambient_light(Span span) {
  if (require(LightVector::color)) add_item(AmbientLight{given(LightVector::color), span});
}

void Builder::end_directional_light(Span span) {
  if (require(LightVector::direction) && require(LightVector::color)) {
    add_item(DirectionalLight{given(LightVector::direction), given(LightVector::color), span});
  }
}

void Builder::end_point_light(Span span) {
  if (require(LightVector::position) && require(LightVector::color)) {
    add_item(PointLight{given(LightVector::position), given(LightVector::color), light_.attenuation[0],
                        light_.attenuation[1], light_.attenuation[2], span});
  }
}

}  // namespace trace::parser
