#include "parser/wording.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/printable.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

std::string_view text_of(const Source& source, Span span) {
  return source.text().substr(span.begin, span.end - span.begin);
}

std::string found_text(const Source& source, const Token& token) {
  if (token.kind == T::END) return "the end of the file";
  if (token.kind == T::STRING) return "the string " + printable(text_of(source, token.span));
  return in_quotes(text_of(source, token.span));
}

std::string block_word(const Source& source, const Frame& frame) {
  switch (frame.owner) {
    case T::END:
      return "scene";
    case T::OPEN_BRACE:
      return "group";
    case T::MATERIAL:
      return "material";
    case T::WORD:
      return "list";
    default:
      return std::string(text_of(source, frame.owner_span));
  }
}

std::string block_text(const Source& source, const Frame& frame) {
  const std::string word = block_word(source, frame);
  if (frame.owner == T::END || frame.owner == T::CAMERA) return "the " + word;
  return (word.front() == 'a' ? "an " : "a ") + word;
}

std::string enumeration(const std::vector<std::string>& parts, std::string_view last_joint) {
  std::string result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) result += i + 1 == parts.size() ? fmt::format(" {} ", last_joint) : ", ";
    result += parts[i];
  }
  return result;
}

std::string expected_text(Kind kind) {
  switch (kind) {
    case T::NUMBER:
      return "a number";
    case T::WORD:
      return "a name";
    case T::STRING:
      return "a name in quotes";
    case T::LIST:
      return "'('";
    case T::END:
      return "the end of the file";
    default:
      return fmt::format("'{}'", spelling(kind));
  }
}

std::string expected_text(const std::vector<Kind>& kinds) {
  const bool names = std::find(kinds.begin(), kinds.end(), T::WORD) != kinds.end();
  std::vector<std::string> parts;
  for (const Kind kind : kinds) {
    if (kind != T::STRING || !names) parts.push_back(expected_text(kind));
  }
  return enumeration(parts, "or");
}

std::string takes_text(const Source& source, const Frame& frame) {
  const std::vector<std::string_view> words = usual_words(frame.owner);
  return fmt::format("{} takes {}", block_text(source, frame),
                     enumeration({words.begin(), words.end()}, "and"));
}

std::string objects_text() {
  std::vector<std::string> words;
  for (const std::string_view word : usual_words(T::OPEN_BRACE)) {
    if (word != spelling(T::MATERIAL)) words.emplace_back(word);
  }
  return "the objects are " + enumeration(words, "and");
}

}  // namespace trace::parser
