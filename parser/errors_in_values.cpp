// Errors on the right-hand side of an attribute.
#include <fmt/format.h>

#include "parser/printable.hpp"
#include "parser/situation.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

bool explain_string_escape(const Situation& at) {
  const std::string_view before = at.text(at.last);
  if (at.last.kind != T::STRING || before.size() < 3 || before[before.size() - 2] != '\\') return false;
  if (at.last.span.end != at.found.span.begin) return false;
  at.tokens.diagnostics().error({at.last.span.end - 2, at.last.span.end},
                                "strings have no escapes: this '\"' ends the string");
  at.tokens.drop_current();
  return true;
}

// A name should stand here: of an object, or of a material.
bool explain_name(const Situation& at) {
  if (!at.expects(T::WORD) || at.last.kind == T::COMMA || at.last.kind == T::OPEN_PAREN) return false;
  const bool reference = at.expects(T::OPEN_BRACE);
  if (is_keyword(at.found.kind) && !reference) {
    at.error(fmt::format("'{}' is a reserved word: put it in quotes to use it as a name", at.text(at.found)));
    at.tokens.drop_current();
  } else {
    at.error_found(reference ? "'material' takes a block '{ ... }' or the name of a material"
                             : "expected a name");
    if (reference && begins_statement(T::MATERIAL, at.found.kind)) at.tokens.assume_open(T::OPEN_BRACE);
  }
  return true;
}

bool explain_value(const Situation& at) {
  if (at.last.kind != T::EQUALS) return false;
  const std::string word(at.text(at.before_last));
  const bool map = at.expects(T::MAP);
  if (at.expects(T::NUMBER)) {
    if (at.expects(T::OPEN_PAREN)) {
      at.error_found(fmt::format("'{}' takes a number or three in parentheses", word));
    } else if (at.found.kind == T::OPEN_PAREN) {
      at.error(fmt::format("'{}' takes one number, not a list", word));
    } else {
      at.error_found(fmt::format("'{}' takes a number{}", word, map ? " or a map" : ""));
    }
  } else if (at.expects(T::OPEN_PAREN)) {
    if (at.before_last.kind == T::MATERIALS) {
      at.error_found("'materials' takes a list in parentheses");
      return true;
    }
    const std::string_view count = at.before_last.kind == T::QUATERNIAN ? "four" : "three";
    at.error_found(
        fmt::format("'{}' takes {} numbers in parentheses{}", word, count, map ? " or a map" : ""));
  } else if (map) {
    at.error_found(fmt::format("'{}' takes a map", word));
  } else if (at.expects(T::STRING)) {
    at.error_found(fmt::format("'{}' takes a file name in quotes", word));
  } else if (at.expects(T::TRUE)) {
    at.error_found(fmt::format("'{}' takes true or false", word));
  } else if (at.expects(T::LIST)) {
    at.error_found(fmt::format("'{}' takes a list in parentheses", word));
  } else {
    return false;
  }
  return true;
}

// Inside the parentheses of a value: three or four numbers, the file of a map, a row of a matrix, or
// materials.
bool explain_tuple(const Situation& at) {
  const Frame& frame = at.frame;
  const bool row = frame.owner == T::LIST;
  if (frame.opener != T::OPEN_PAREN || is_transform(frame.owner)) return false;
  if (frame.owner == T::MAP) {
    at.error_found(at.last.kind == T::COMMA && at.expects(T::STRING)
                       ? "a map of two files: expected the second in quotes"
                   : at.expects(T::STRING) ? "expected a file name in quotes"
                   : at.expects(T::NUMBER) ? "expected the threshold from which the second map shows"
                   : at.expects_only(T::COMMA)
                       ? "a map of two files: expected ',' and the threshold from which the second shows"
                   : at.last.kind == T::STRING ? "expected ')' after the file name"
                                               : "expected ')' after the threshold");
    return true;
  }
  if (frame.owner == T::MATERIALS) {
    at.error_found(at.expects(T::COMMA) ? "expected ',' or ')' after a material" : "expected a material");
    if (begins_statement(T::MATERIAL, at.found.kind)) at.tokens.assume_open(T::OPEN_BRACE);
    return true;
  }
  if (at.expects(T::NUMBER)) {
    at.error_found("expected a number");
    return true;
  }
  const std::string what =
      row ? "a row of 'transform'" : fmt::format("'{}'", text_of(at.source, frame.owner_span));
  const bool four = row || frame.owner == T::QUATERNIAN;
  at.error_found(fmt::format("{} takes {} numbers: expected '{}'", what, four ? "four" : "three",
                             spelling(at.expected.front())));
  return true;
}

}  // namespace trace::parser
