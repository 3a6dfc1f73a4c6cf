// The parts of Builder that read cameras, lights and surroundings.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parser/builder.hpp"
#include "parser/dialect_words.hpp"
#include "parser/printable.hpp"

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

void Builder::look_at(Vector3 value, Span word) {
  camera_.look_at = value;
  look_at_word_ = word;
}

void Builder::projection(const Name& name) {
  if (name.value != "perspective" && name.value != "orthographic") {
    diagnostics_
        .error(name.span,
               fmt::format("unknown projection {}: write perspective or orthographic", in_quotes(name.value)))
        .suggestion = closest(name.value, {"perspective", "orthographic"});
    return;
  }
  camera_.orthographic = Located<bool>{name.value == "orthographic", name.span};
}

void Builder::camera_height(Scalar value) {
  camera_.height = value;
  if (value.value > 0) return;
  diagnostics_.error(value.span, "the 'height' of a camera must be greater than 0");
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
  if (!errors_since_begin() && camera_.look_at && camera_.viewdir) {
    diagnostics_.error(look_at_word_, "the camera gives both 'viewdir' and 'look_at'");
  }
  if (!errors_since_begin() && camera_.updir && !camera_.viewdir && !camera_.look_at) {
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

void Builder::begin_dialect_light(DialectLight::Kind kind, Span keyword) {
  dialect_light_ = {};
  dialect_light_.kind = kind;
  dialect_light_.word =
      find_dialect_word(T::END, source_.text().substr(keyword.begin, keyword.end - keyword.begin))->word;
  dialect_light_.keyword = keyword;
  light_.word = dialect_light_.word;
}

void Builder::light_attribute(std::string_view word, std::variant<double, std::array<double, 3>> value,
                              Span word_span, Span value_span) {
  if (const DialectLight::Attribute* const first = dialect_light_.find(word)) {
    return given_twice(word, first->span, word_span);
  }
  dialect_light_.attributes.push_back({word, value, word_span, value_span});
}

void Builder::end_dialect_light(Span span) {
  dialect_light_.span = span;
  add_item(std::move(dialect_light_));
}

// --- surroundings ------------------------------------------------------------------------------------------

void Builder::begin_fog(Span keyword) {
  fog_ = {};
  fog_.keyword = keyword;
}

void Builder::end_fog(Span span) {
  fog_.span = span;
  add_item(fog_);
}

void Builder::begin_surroundings(bool skybox, Span keyword) {
  surroundings_ = {};
  surroundings_.skybox = skybox;
  surroundings_.keyword = keyword;
  errors_before_ = diagnostics_.error_count();
}

void Builder::face(std::string_view word, Name file, Span word_span) {
  // As Surroundings::faces has them.
  constexpr std::array<std::string_view, 6> of_cube{"posx", "negx", "posy", "negy", "posz", "negz"};
  constexpr std::array<std::string_view, 6> of_sky{"right", "left", "top", "bottom", "front", "back"};
  const auto& words = surroundings_.skybox ? of_sky : of_cube;
  const auto place = static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
  std::optional<Name>& face = surroundings_.faces[place];
  if (face) {
    diagnostics_.error(word_span, fmt::format("'{}' is given twice in this {}", word,
                                              surroundings_.skybox ? "skybox" : "cubemap"));
  }
  face = std::move(file);
}

void Builder::end_surroundings(Span span) {
  surroundings_.span = span;
  const auto given = std::count_if(surroundings_.faces.begin(), surroundings_.faces.end(),
                                   [](const auto& face) { return face.has_value(); });
  if (!errors_since_begin() && surroundings_.file && given > 0) {
    diagnostics_.error(surroundings_.keyword, "a cubemap takes 'file' or six faces, not both");
  } else if (!errors_since_begin() && !surroundings_.file && given < 6) {
    diagnostics_.error(
        surroundings_.keyword,
        fmt::format("{} has {} of its six faces", surroundings_.skybox ? "skybox" : "cubemap", given));
  }
  add_item(std::move(surroundings_));
}

void Builder::without_effect(std::string_view word, Span span, std::string_view block) {
  diagnostics_.warning(span, fmt::format("'{}' has no effect in {}", word, block));
}

}  // namespace trace::parser
