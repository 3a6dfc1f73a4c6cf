#include "parser/list_errors.hpp"

#include <fmt/format.h>

#include "parser/syntax_error.hpp"
#include "parser/wording.hpp"

namespace trace::parser {

namespace {

std::string needed(ListNeed need, std::string_view entry) {
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
      return fmt::format("a {} takes three numbers: expected ','", entry);
    case ListNeed::close:
      return fmt::format("a {} takes three numbers: expected ')'", entry);
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
  const std::string entry = attribute.substr(0, attribute.size() - 1);  // "points" without its "s"
  diagnostics.error(found.span, needed(need, entry) + ", found " + found_text(tokens.source(), found));
}

}  // namespace trace::parser
