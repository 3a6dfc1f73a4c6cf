#include "parser/token_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parser/builder.hpp"
#include "parser/dialect_words.hpp"
#include "parser/list_errors.hpp"
#include "parser/parse.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

TokenStream::TokenStream(const Source& source, Diagnostics& diagnostics, Builder& builder, bool permissive)
    : source_(source),
      diagnostics_(diagnostics),
      builder_(builder),
      permissive_(permissive),
      scanner_(source, diagnostics) {}

// The token returned before has been taken by the grammar: only now do its brackets count.
bison::Grammar::symbol_type TokenStream::next() {
  if (taken_ && !stopped_) {
    current_.kind == T::PLAIN_MATERIALS ? frames_.pass_materials(current_) : frames_.apply(current_);
    check_nesting(current_);
  }
  taken_ = true;
  current_ = stopped_ ? Token{T::END, current_.span} : skipping_ ? skip() : advance();
  return symbol(current_);
}

Token TokenStream::scan() {
  Token token = scanner_.next();
  if (token.kind == T::WORD) token.kind = dialect_kind(token);
  return token;
}

// A word counts where a statement may begin, or an object in a transform; in front of a value as the function
// that makes one.
Kind TokenStream::dialect_kind(const Token& word) const {
  const std::string_view text = source_.text().substr(word.span.begin, word.span.end - word.span.begin);
  const Frame& frame = frames_.top();
  const Kind last = frames_.last().kind, attribute = frames_.before_last().kind;
  if (last == T::EQUALS) {
    if (text == "bump" && attribute == T::BUMP) return T::MAP;
    const bool color = attribute >= T::EMISSIVE && attribute <= T::TRANSMISSIVE;
    return text == "marble" && color ? T::MARBLE : T::WORD;
  }
  if (last == T::NAME && frame.owner == T::MATERIAL) return T::WORD;
  const bool in_transform = frame.opener == T::OPEN_PAREN && is_transform(frame.owner);
  if (!frame.is_block() && !in_transform) return T::WORD;
  return dialect_word(in_transform ? T::OPEN_BRACE : frame.owner, text).value_or(T::WORD);
}

Token TokenStream::advance() {
  if (!held_.empty()) {
    const Token token = held_.back();
    held_.pop_back();
    return token;
  }
  const Token token = scan();
  if (at_vertex_material(token)) return read_plain_materials(token);
  const Kind attribute = frames_.before_last().kind;
  const bool list = attribute == T::POINTS || attribute == T::NORMALS || attribute == T::FACES ||
                    attribute == T::TEXTURE_UV;
  Token result =
      list && token.kind == T::OPEN_PAREN && frames_.last().kind == T::EQUALS ? read_list(token) : token;
  if (silence_next_ && result.kind != T::LIST) {
    result.after_error = true;
    silence_next_ = false;
  }
  return result;
}

Token TokenStream::skip() {
  scanner_.set_quiet(true);
  Token token = scan();
  while (token.kind != T::END && !frames_.skip(token, target_)) {
    if (frames_.depth() > 2 * max_nesting) {
      stop();
      token = {T::END, token.span};
      break;
    }
    token = scan();
  }
  scanner_.set_quiet(false);
  skipping_ = false;
  if (token.kind == T::END) stop();
  return token;
}

Recovery TokenStream::recover() {
  if (stopped_ || current_.kind == T::END) {
    stop();
    return Recovery::stop;
  }
  if (std::exchange(insert_brace_, false)) {
    const Token brace{T::CLOSE_BRACE, {current_.span.begin, current_.span.begin}};
    held_ = {current_, brace};
    taken_ = false;
    return Recovery::drop;
  }
  target_ = frames_.block_depth();
  const bool stuck = last_error_ == current_.span.begin;
  last_error_ = current_.span.begin;
  if (assumed_open_) frames_.skip({*assumed_open_, {current_.span.begin, current_.span.begin}}, target_);
  assumed_open_.reset();
  const bool word = current_.kind == T::WORD || is_keyword(current_.kind);
  const bool drop = std::exchange(drop_current_, false) || stuck ||
                    (word && !begins_statement(frames_.at(target_).owner, current_.kind));
  const bool begins_next = frames_.skip(current_, target_);
  if (begins_next && !drop) return Recovery::keep;
  if (begins_next && word) frames_.pass_word(current_);
  taken_ = false;
  skipping_ = true;
  return Recovery::drop;
}

bool TokenStream::first_note(Kind block) {
  if (std::find(noted_.begin(), noted_.end(), block) != noted_.end()) return false;
  noted_.push_back(block);
  return true;
}

void TokenStream::check_nesting(const Token& token) {
  if (frames_.nesting() <= max_nesting || stopped_) return;
  diagnostics_.error(token.span, fmt::format("objects are nested more than {} deep", max_nesting));
  stop();
}

bison::Grammar::symbol_type TokenStream::symbol(const Token& token) const {
  using Symbol = bison::Grammar::symbol_type;
  const std::string_view text = source_.text().substr(token.span.begin, token.span.end - token.span.begin);
  switch (token.kind) {
    case T::NUMBER:
      return Symbol(token.kind, token.number, token.span);
    case T::WORD:
      return Symbol(token.kind, text, token.span);
    case T::LIGHT_ATTRIBUTE:
    case T::FACE:
    case T::WITHOUT_EFFECT: {
      // The table's word, which outlives the text.
      const DialectWord* const word = find_dialect_word(frames_.top().owner, text);
      return Symbol(token.kind, word == nullptr ? std::string_view() : word->word, token.span);
    }
    case T::STRING: {
      const bool closed = text.size() > 1 && text.back() == '"';
      return Symbol(token.kind, text.substr(1, text.size() - (closed ? 2 : 1)), token.span);
    }
    default:
      return Symbol(token.kind, token.span);
  }
}

Token TokenStream::read_list(const Token& open) {
  const ListStop stop = builder_.read_list(frames_.before_last().kind, open.span);
  scanner_.seek(stop.offset);
  if (stop.need == ListNeed::nothing) return {T::LIST, {open.span.begin, stop.offset}};
  const Token found = scanner_.next();
  if (!found.after_error) report_list_error(*this, open.span, stop.need, found);
  Token list = leave_list(found, stop);
  list.span.begin = open.span.begin;
  return list;
}

bool TokenStream::at_vertex_material(const Token& token) const {
  if (token.kind != T::OPEN_BRACE || token.after_error || silence_next_) return false;
  const Frame& frame = frames_.top();
  const Kind before = frames_.last().kind;
  return frame.opener == T::OPEN_PAREN && frame.owner == T::MATERIALS &&
         (before == T::OPEN_PAREN || before == T::COMMA);
}

// `open` itself where the entry that it begins is not plain, or the last.
Token TokenStream::read_plain_materials(const Token& open) {
  const std::uint32_t end = builder_.read_plain_materials(open.span);
  if (end == open.span.begin) return open;
  scanner_.seek(end);
  return {T::PLAIN_MATERIALS, {open.span.begin, end}};
}

// Behind an error in a list: up to the ')' of the list. A ';', a '}' or a word stands in none, so it ends one
// that is not closed; what is missing in front of it then is not reported again.
Token TokenStream::leave_list(const Token& found, const ListStop& stop) {
  const bool entry = stop.need == ListNeed::first_entry || stop.need == ListNeed::entry;
  std::size_t depth = stop.inside_entry || (entry && found.kind == T::NUMBER) ? 2 : 1;
  Token token = found;
  scanner_.set_quiet(true);
  for (;; token = scanner_.next()) {
    if (token.kind == T::END || token.kind == T::SEMICOLON || token.kind == T::CLOSE_BRACE ||
        is_keyword(token.kind)) {
      scanner_.seek(token.span.begin);
      silence_next_ = true;
      break;
    }
    if (token.kind == T::OPEN_PAREN) ++depth;
    if (token.kind == T::CLOSE_PAREN && --depth == 0) break;
  }
  scanner_.set_quiet(false);
  return {T::LIST, token.span};
}

}  // namespace trace::parser
