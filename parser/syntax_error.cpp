#include "parser/syntax_error.hpp"

#include <fmt/format.h>

#include <array>

#include "parser/dialect_words.hpp"
#include "parser/foreign_words.hpp"
#include "parser/number.hpp"
#include "parser/printable.hpp"
#include "parser/situation.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

bool Situation::found_word() const {
  return found.kind == T::WORD || is_keyword(found.kind);
}

Kind Situation::found_kind() const {
  return found.kind == T::WORD ? dialect_word(T::END, text(found)).value_or(T::WORD) : found.kind;
}

Diagnostic& Situation::error(std::string message) const {
  return tokens.diagnostics().error(found.span, std::move(message));
}

Diagnostic& Situation::error_found(const std::string& message) const {
  return error(message + ", found " + found_text());
}

void Situation::suggest(Diagnostic& diagnostic, Kind block) const {
  if (found_word()) diagnostic.suggestion = closest(text(found), statement_words(block));
}

bool Situation::lists_words() const {
  return !tokens.permissive() && foreign_word(text(found)).empty();
}

Diagnostic& Situation::unknown(std::string_view what, const std::string& where, Kind block) const {
  const std::string word = in_quotes(text(found));
  const std::string_view foreign = foreign_word(text(found));
  std::string message = fmt::format("unknown {} {}{}", what, word, where);
  if (!foreign.empty()) message = fmt::format("{} {}; it is not part of this language", word, foreign);
  if (tokens.permissive()) {
    return tokens.diagnostics().warning(found.span,
                                        message + (foreign.empty() ? ": passed over" : ", and passed over"));
  }
  Diagnostic& diagnostic = error(message);
  if (foreign.empty()) suggest(diagnostic, block);
  return diagnostic;
}

Note Situation::opened_here(const Frame& opened) const {
  const std::string word = block_word(source, opened);
  if (opened.owner == T::OPEN_BRACE) return {opened.owner_span, "the group is opened here"};
  if (opened.owner == T::MATERIAL) return {opened.owner_span, "the material is opened here"};
  return {opened.owner_span, fmt::format("'{}' is opened here", word)};
}

bool report_glued_number(const Source& source, const Token& found, Diagnostics& diagnostics) {
  if (found.kind != T::WORD && !is_keyword(found.kind)) return false;
  const std::string_view text = source.text();
  const auto in_number = [](char c) { return is_digit(c) || c == '.'; };
  std::uint32_t begin = found.span.begin;
  if (begin == 0 || !in_number(text[begin - 1])) return false;
  while (begin > 0 && (begins_number(text[begin - 1]) || text[begin - 1] == 'e' || text[begin - 1] == 'E'))
    --begin;
  const Span span{begin, found.span.end};
  diagnostics.error(span, "malformed number " + in_quotes(text_of(source, span)));
  return true;
}

void report_syntax_error(TokenStream& tokens, const std::vector<Kind>& expected) {
  const Frames& frames = tokens.frames();
  const Token& found = tokens.current();
  if (tokens.stopped() || found.after_error) return;
  const Situation at{tokens, expected,      tokens.source(),     frames.top(),
                     found,  frames.last(), frames.before_last()};
  constexpr std::array explain{
      explain_header,
      explain_end_of_file,
      explain_string_escape,
      explain_missing_equals,
      explain_missing_semicolon,
      explain_name,
      explain_value,
      explain_tuple,
      explain_opening,
      explain_attribute,
      explain_transform,
      explain_object,
  };
  if (report_glued_number(at.source, found, tokens.diagnostics())) return;
  for (const auto function : explain) {
    if (function(at)) return;
  }
  at.error_found("expected " + expected_text(expected));
}

}  // namespace trace::parser
