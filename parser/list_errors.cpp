#include "parser/list_errors.hpp"

#include <fmt/format.h>

#include "parser/syntax_error.hpp"
#include "parser/wording.hpp"

namespace trace::parser {

namespace {

// What the entries of a list are called, and how many numbers they have.
struct Entries {
  std::string name;
  std::string_view count = "three";
};

Entries entries_of(Kind attribute, const std::string& word) {
  if (attribute == T::TEXTURE_UV) return {"pair", "two"};
  return {word.substr(0, word.size() - 1)};  // "points" without its "s"
}

std::string needed(ListNeed need, const Entries& entries) {
  const std::string& entry = entries.name;
  switch (need) {
    case ListNeed::nothing:
      return "";
    case ListNeed::first_entry:
      return fmt::format("expected '(' of a {} or ')'", entry);
    case ListNeed::entry:
      return fmt::format("expected '(' of another {} after ','", entry);
    case ListNeed::number:
      return "expected a number";
    case ListNeed::comma:
      return fmt::format("a {} takes {} numbers: expected ','", entry, entries.count);
    case ListNeed::close:
      return fmt::format("a {} takes {} numbers: expected ')'", entry, entries.count);
    case ListNeed::comma_or_close:
      return fmt::format("expected ',' or ')' in a {}", entry);
    case ListNeed::comma_or_end:
      return fmt::format("expected ',' or ')' after a {}", entry);
  }
  return "";
}

}  // namespace

void report_list_error(TokenStream& tokens, Span open, ListNeed need, const Token& found) {
  const std::string attribute(text_of(tokens.source(), tokens.frames().before_last().span));
  Diagnostics& diagnostics = tokens.diagnostics();
  if (found.kind == T::END) {
    diagnostics
        .error(found.span,
               fmt::format("unexpected end of file: the ')' of this list of {} is missing", attribute))
        .notes.push_back({open, "the list is opened here"});
    tokens.stop();
    return;
  }
  if (report_glued_number(tokens.source(), found, diagnostics)) return;
  const Entries entries = entries_of(tokens.frames().before_last().kind, attribute);
  diagnostics.error(found.span, needed(need, entries) + ", found " + found_text(tokens.source(), found));
}

}  // namespace trace::parser
