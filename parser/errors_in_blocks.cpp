// Errors where a statement begins or ends.
#include <fmt/format.h>

#include "parser/printable.hpp"
#include "parser/situation.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

namespace {

// Whether the found token would be right behind the '}' of this block, or at least somewhere further out.
bool fits_outside(const Situation& at) {
  const Frame& outside = at.tokens.frames().parent();
  const bool group =
      at.found.kind == T::OPEN_BRACE && (outside.owner == T::END || outside.owner == T::OPEN_BRACE);
  return outside.is_block() && (group || begins_statement(outside.owner, at.found_kind()));
}
bool belongs_outside(const Situation& at) {
  return fits_outside(at) || begins_statement(T::END, at.found_kind());
}

std::string_view arguments_of(Kind transform) {
  switch (transform) {
    case T::TRANSLATE:
      return "three numbers and one object";
    case T::ROTATE:
      return "three numbers for the axis, an angle and one object";
    case T::SCALE:
      return "one or three numbers and one object";
    default:
      return "four rows of four numbers and one object";
  }
}

// A light, a camera or what surrounds a scene inside of something.
bool explain_misplaced(const Situation& at, const std::string& where) {
  const Kind kind = at.found_kind();
  const bool light = is_light(kind), surroundings = kind == T::FOG || kind == T::CUBEMAP || kind == T::SKYBOX;
  if (!light && !surroundings && kind != T::CAMERA) return false;
  at.error(fmt::format("'{}' cannot stand in {}: {} at the top level of the scene", at.text(at.found), where,
                       light          ? "lights stand"
                       : surroundings ? "it stands"
                                      : "cameras stand"));
  return true;
}

// A ')' that closes what is around the block, or a ',' of the list that it stands in: the block's '}' is
// missing.
bool explain_unclosed(const Situation& at) {
  const Frame& outside = at.tokens.frames().parent();
  const bool comma = at.found.kind == T::COMMA && outside.owner == T::MATERIALS;
  if (outside.opener != T::OPEN_PAREN || (at.found.kind != T::CLOSE_PAREN && !comma)) return false;
  at.error(fmt::format("'}}' of this {} is missing before '{}'", block_word(at.source, at.frame),
                       at.text(at.found)))
      .notes.push_back(at.opened_here(at.frame));
  at.tokens.insert_brace();
  return true;
}

}  // namespace

bool explain_missing_equals(const Situation& at) {
  const bool or_block = at.last.kind == T::MATERIAL && at.expects(T::EQUALS);
  if (!at.expects_only(T::EQUALS) && !or_block) return false;
  at.error_found(fmt::format("expected '=' after '{}'", at.text(at.last)));
  return true;
}

// Only where it is mandatory: behind lists, gennormals and the name of a material.
bool explain_missing_semicolon(const Situation& at) {
  const bool after_gennormals = at.last.kind == T::GENNORMALS && at.expects(T::SEMICOLON);
  if (!at.expects_only(T::SEMICOLON) && !after_gennormals) return false;
  const std::string word(text_of(at.source, at.frame.statement_span));
  std::string after = "the list of " + word;
  if (at.frame.statement == T::GENNORMALS) after = "'gennormals', which takes no value";
  if (at.frame.statement == T::NAME) after = "the name of a material";
  at.error_found(fmt::format("expected ';' after {}", after));
  return true;
}

bool explain_opening(const Situation& at) {
  const bool opens =
      at.expects_only(T::OPEN_BRACE) || (at.expects_only(T::OPEN_PAREN) && at.last.kind != T::EQUALS);
  if (!opens || at.last.kind == T::COMMA || at.last.kind == T::OPEN_PAREN) return false;
  const Kind bracket = at.expected.front();
  at.error_found(fmt::format("expected '{}' after '{}'", spelling(bracket), at.text(at.last)));
  const bool inside = bracket == T::OPEN_PAREN ? at.found.kind == T::NUMBER
                                               : begins_statement(at.last.kind, at.found.kind) &&
                                                     !begins_statement(at.frame.owner, at.found.kind);
  if (inside) at.tokens.assume_open(bracket);
  return true;
}

// Where an attribute of a block, or its '}', should stand.
bool explain_attribute(const Situation& at) {
  const Frame& frame = at.frame;
  if (frame.opener != T::OPEN_BRACE || frame.owner == T::OPEN_BRACE || !at.expects(T::CLOSE_BRACE))
    return false;
  const std::string block = block_text(at.source, frame);
  if (belongs_outside(at)) {
    if (fits_outside(at)) at.tokens.insert_brace();
    if (at.tokens.brackets_lost()) return true;
    at.error(fmt::format("'{}' cannot stand in {}: is a '}}' missing before it?", at.text(at.found), block))
        .notes.push_back(at.opened_here(frame));
  } else if (explain_unclosed(at)) {
    return true;
  } else if (at.found_word()) {
    Diagnostic& error = at.unknown("attribute", " in " + block, frame.owner);
    if (at.lists_words() && at.tokens.first_note(frame.owner))
      error.notes.push_back({at.found.span, takes_text(at.source, frame)});
  } else if (at.found.kind == T::COMMA && at.last.kind == T::NUMBER && frame.statement != T::END) {
    at.error(fmt::format("'{}' takes one number", text_of(at.source, frame.statement_span)));
  } else {
    at.error_found(fmt::format("expected an attribute of {} or '}}'", block));
  }
  return true;
}

// Inside the parentheses of a transform.
bool explain_transform(const Situation& at) {
  const Frame& frame = at.frame;
  if (frame.opener != T::OPEN_PAREN || !is_transform(frame.owner)) return false;
  const std::string word = block_word(at.source, frame);
  if (at.expects(T::CLOSE_PAREN) && !at.expects_object()) {
    if (at.found.kind == T::COMMA || at.found.kind == T::OPEN_BRACE ||
        begins_statement(T::OPEN_BRACE, at.found.kind)) {
      at.error(fmt::format("{} takes one object: put several between '{{' and '}}'", word))
          .notes.push_back(at.opened_here(frame));
    } else {
      at.error_found(fmt::format("expected ')' of this {}", word)).notes.push_back(at.opened_here(frame));
    }
    return true;
  }
  const std::string takes = fmt::format("{} takes {}", word, arguments_of(frame.owner));
  if (!at.expects_object()) {
    const bool no_object = at.expects_only(T::COMMA) && at.found.kind == T::CLOSE_PAREN;
    at.error_found(
        fmt::format("{}: expected {}", takes, no_object ? "',' and more" : expected_text(at.expected)));
    if (at.expects_only(T::OPEN_PAREN) && at.found.kind == T::NUMBER) at.tokens.assume_open(T::OPEN_PAREN);
    return true;
  }
  if (explain_misplaced(at, fmt::format("{} {}", word.front() == 'a' ? "an" : "a", word))) return true;
  if (at.found.kind == T::WORD) {
    Diagnostic& error = at.unknown("object", "", T::OPEN_BRACE);
    if (at.lists_words() && at.tokens.first_note(T::OPEN_BRACE))
      error.notes.push_back({at.found.span, objects_text()});
  } else {
    at.error_found(fmt::format("{}: expected {}", takes,
                               at.expects(T::NUMBER) ? "a number or the object" : "the object"));
  }
  return true;
}

// Where an object should stand in a group or in the scene.
bool explain_object(const Situation& at) {
  if (!at.expects_object()) return false;
  const bool group = at.frame.owner == T::OPEN_BRACE;
  const std::string choice = group ? "an object or a material" : "an object, a light, a camera or a material";
  if (at.found_word() && group && explain_misplaced(at, "a group")) {
    return true;
  } else if (at.found.kind == T::WORD) {
    Diagnostic& error =
        at.unknown("word", at.tokens.permissive() ? "" : ": expected " + choice, at.frame.owner);
    if (at.lists_words() && at.tokens.first_note(at.frame.owner))
      error.notes.push_back({at.found.span, takes_text(at.source, at.frame)});
  } else if (at.found_word()) {
    at.error(fmt::format("'{}' cannot stand {}: expected {}", at.text(at.found),
                         group ? "in a group" : "at the top level of the scene", choice));
  } else if (group && explain_unclosed(at)) {
    return true;
  } else if (at.found.kind == T::CLOSE_BRACE || at.found.kind == T::CLOSE_PAREN) {
    if (at.tokens.brackets_lost() && at.tokens.diagnostics().has_errors()) return true;
    at.error(fmt::format("unexpected '{0}': there is no '{1}' that it could close", at.text(at.found),
                         at.found.kind == T::CLOSE_BRACE ? "{" : "("));
  } else {
    at.error_found("expected " + choice);
  }
  return true;
}

}  // namespace trace::parser
