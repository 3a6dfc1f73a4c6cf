#include "parser/plain_materials.hpp"

#include <cstring>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "parser/comments.hpp"
#include "parser/number.hpp"
#include "parser/plain_number.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

namespace {

std::optional<Parameter> parameter_of(std::string_view word) {
  switch (reserved_word(word).value_or(T::WORD)) {
    case T::EMISSIVE:
      return Parameter::emissive;
    case T::AMBIENT:
      return Parameter::ambient;
    case T::DIFFUSE:
      return Parameter::diffuse;
    case T::SPECULAR:
      return Parameter::specular;
    case T::REFLECTIVE:
      return Parameter::reflective;
    case T::TRANSMISSIVE:
      return Parameter::transmissive;
    case T::INDEX:
      return Parameter::index;
    case T::SHININESS:
      return Parameter::shininess;
    default:
      return std::nullopt;
  }
}

// Each function reads what it is named after, blanks and comments in front of it too, and returns the place
// behind it; null where something else stands there.
class BlockReader {
 public:
  explicit BlockReader(const Source& source)
      : text_(source.text().data()), end_(text_ + source.text().size()) {}

  const char* character(const char* at, char c) const {
    at = skip_blanks(at, end_);
    return *at == c ? at + 1 : nullptr;
  }

  const char* block(const char* at, MaterialBlock& block) const {
    at = character(at, '{');
    while (at != nullptr) {
      at = skip_blanks(at, end_);
      if (*at == '}') return at + 1;
      at = *at == ';' ? at + 1 : assignment(at, block.assignments.emplace_back());
    }
    return nullptr;
  }

  Span span(const char* begin, const char* end) const {
    return {static_cast<std::uint32_t>(begin - text_), static_cast<std::uint32_t>(end - text_)};
  }

 private:
  const char* number(const char* at, double& value) const {
    at = skip_blanks(at, end_);
    const char* const behind = read_plain_number(at, value);
    if (behind != nullptr && (*behind == ',' || *behind == ')' || *behind == ';')) return behind;
    if (!begins_number(*at)) return nullptr;
    const NumberText number = read_number(at, end_);
    value = number.value;
    return number.state == NumberState::good ? number.end : nullptr;
  }

  const char* color(const char* at, std::array<double, 3>& value) const {
    at = character(at, '(');
    for (std::size_t i = 0; i < 3 && at != nullptr; ++i) {
      at = number(at, value[i]);
      if (at != nullptr) at = character(at, i < 2 ? ',' : ')');
    }
    return at;
  }

  const char* assignment(const char* at, MaterialAssignment& result) const {
    const char* const begin = at;
    while (continues_word(*at)) ++at;
    const auto parameter = parameter_of({begin, static_cast<std::size_t>(at - begin)});
    if (!parameter) return nullptr;
    at = character(at, '=');
    if (at == nullptr) return nullptr;
    const char* const value = skip_blanks(at, end_);
    if (*parameter == Parameter::index || *parameter == Parameter::shininess) {
      at = number(value, result.value.emplace<double>());
    } else {
      at = color(value, result.value.emplace<std::array<double, 3>>());
    }
    if (at == nullptr) return nullptr;
    result.parameter = *parameter;
    result.span = span(begin, at);
    result.value_span = span(value, at);
    return at;
  }

  const char* text_;
  const char* end_;
};

}  // namespace

std::uint32_t read_plain_materials(const Source& source, std::uint32_t begin, VertexMaterials& materials) {
  const BlockReader reader(source);
  const char* const text = source.text().data();
  const char* const end = text + source.text().size();
  std::unordered_map<std::string_view, std::uint32_t>
      known;  // text of a plain block -> its place in materials
  std::uint32_t done = begin;
  for (const char* at = text + begin; *at == '{'; at = skip_blanks(text + done, end)) {
    const void* const brace = std::memchr(at, '}', static_cast<std::size_t>(end - at));
    if (brace == nullptr) break;
    const char* behind = static_cast<const char*>(brace) + 1;
    const auto same = known.find({at, static_cast<std::size_t>(behind - at)});
    MaterialBlock block;
    if (same == known.end()) {
      block.assignments.reserve(8);  // as many as there are parameters
      behind = reader.block(at, block);
    }
    const char* const comma = behind == nullptr ? nullptr : reader.character(behind, ',');
    if (comma == nullptr) break;
    if (same == known.end()) {
      known.emplace(std::string_view(at, static_cast<std::size_t>(behind - at)),
                    static_cast<std::uint32_t>(materials.materials.size()));
      materials.add({std::move(block), reader.span(at, behind)});
    } else {
      materials.of.push_back(same->second);
    }
    done = static_cast<std::uint32_t>(comma - text);
  }
  return done;
}

}  // namespace trace::parser
