#include "parser/frames.hpp"

#include "parser/vocabulary.hpp"

namespace trace::parser {

namespace {

bool nests(const Frame& frame) {
  return frame.owner == T::OPEN_BRACE || (frame.opener == T::OPEN_PAREN && is_transform(frame.owner));
}

bool opens_block(Kind kind) {
  return is_primitive(kind) || is_light(kind) || kind == T::CAMERA || kind == T::FOG || kind == T::CUBEMAP ||
         kind == T::SKYBOX || kind == T::MARBLE;
}

}  // namespace

void Frames::open(const Token& token) {
  Frame frame;
  frame.opener = token.kind;
  frame.open_span = frame.owner_span = token.span;
  frame.owner = token.kind == T::OPEN_BRACE ? T::OPEN_BRACE : T::WORD;
  const bool brace = token.kind == T::OPEN_BRACE;
  if (last_.kind == T::EQUALS &&
      (!brace || before_last_.kind == T::MATERIAL || before_last_.kind == T::PERLIN_NOISE)) {
    frame.owner = before_last_.kind;
    frame.owner_span = before_last_.span;
  } else if (brace && top().opener == T::OPEN_PAREN && top().owner == T::MATERIALS) {
    frame.owner = T::MATERIAL;
  } else if (!brace && top().opener == T::OPEN_PAREN && top().owner == T::TRANSFORM) {
    frame.owner = T::LIST;
  } else if (brace ? opens_block(last_.kind) || last_.kind == T::WORD || last_.kind == T::MATERIAL
                   : is_transform(last_.kind) || last_.kind == T::MAP) {
    frame.owner = last_.kind;
    frame.owner_span = last_.span;
  }
  nesting_ += nests(frame) ? 1 : 0;
  frames_.push_back(frame);
}

void Frames::close() {
  nesting_ -= nests(frames_.back()) ? 1 : 0;
  frames_.pop_back();
}

void Frames::pass_materials(const Token& materials) {
  const std::uint32_t end = materials.span.end;
  before_last_ = {T::CLOSE_BRACE, {end - 1, end - 1}};
  last_ = {T::COMMA, {end - 1, end}};
}

void Frames::pass_word(const Token& word) {
  before_last_ = last_;
  last_ = word;
}

void Frames::apply(const Token& token) {
  switch (token.kind) {
    case T::OPEN_BRACE:
    case T::OPEN_PAREN:
      open(token);
      break;
    case T::CLOSE_BRACE:
      if (top().opener == T::OPEN_BRACE) close();
      break;
    case T::CLOSE_PAREN:
      if (top().opener == T::OPEN_PAREN) close();
      break;
    case T::COMMA:
      ++frames_.back().commas;
      break;
    case T::SEMICOLON:
      if (top().is_block()) frames_.back().statement = T::END;
      break;
    default:
      if (top().is_block() && last_.kind != T::EQUALS && begins_statement(top().owner, token.kind)) {
        frames_.back().statement = token.kind;
        frames_.back().statement_span = token.span;
      }
  }
  before_last_ = last_;
  last_ = token;
}

std::size_t Frames::block_depth() const {
  std::size_t depth = frames_.size() - 1;
  while (!frames_[depth].is_block()) --depth;
  return depth;
}

// Parentheses of values hold no ';', so one ends them; those of transforms may.
bool Frames::only_values_above(std::size_t depth) const {
  for (std::size_t i = frames_.size() - 1; i > depth; --i) {
    if (frames_[i].is_block() || is_transform(frames_[i].owner) || frames_[i].owner == T::MATERIALS)
      return false;
  }
  return true;
}

// A '}' closes the innermost '{' above or at `depth`, with everything left open inside.
bool Frames::skip_brace(std::size_t depth) {
  while (depth + 1 < frames_.size() && top().opener != T::OPEN_BRACE) {
    bracket_lost_ = true;
    close();
  }
  if (frames_.size() - 1 > depth) {
    close();
    return false;
  }
  if (depth == 0) bracket_lost_ = true;
  return depth > 0;
}

bool Frames::skip(const Token& token, std::size_t depth) {
  const bool here = frames_.size() - 1 == depth;
  const bool behind_bracket = last_.kind == T::CLOSE_BRACE || last_.kind == T::CLOSE_PAREN;
  switch (token.kind) {
    case T::CLOSE_BRACE:
      if (skip_brace(depth)) return true;
      break;
    case T::CLOSE_PAREN:
      if (!here && top().opener == T::OPEN_PAREN) {
        close();
      } else {
        bracket_lost_ = true;
      }
      break;
    case T::SEMICOLON:
      if (!here && only_values_above(depth)) {
        while (frames_.size() - 1 > depth) close();
        return true;
      }
      if (here) return true;
      break;
    case T::OPEN_BRACE:
      if (here && behind_bracket && (top().owner == T::END || top().owner == T::OPEN_BRACE)) return true;
      [[fallthrough]];
    case T::OPEN_PAREN:
      open(token);
      break;
    default:
      if (here && begins_statement(top().owner, token.kind)) return true;
      if (here && behind_bracket && (token.kind == T::WORD || begins_statement(T::END, token.kind)))
        return true;
  }
  before_last_ = last_;
  last_ = token;
  return false;
}

}  // namespace trace::parser
