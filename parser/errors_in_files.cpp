// Errors at the header and at the end of the file.
#include <fmt/format.h>

#include "parser/printable.hpp"
#include "parser/situation.hpp"
#include "parser/vocabulary.hpp"

namespace trace::parser {

bool explain_header(const Situation& at) {
  if (at.expects_only(T::HEADER)) {
    Diagnostic& error = at.error("the file does not begin with 'SBT-raytracer'");
    if (at.found_word()) error.suggestion = closest(at.text(at.found), {"SBT-raytracer"});
  } else if (at.last.kind == T::HEADER) {
    at.error_found("expected the version number after 'SBT-raytracer'");
  } else {
    return false;
  }
  at.tokens.stop();  // this is another kind of file
  return true;
}

bool explain_end_of_file(const Situation& at) {
  if (at.found.kind != T::END) return false;
  at.tokens.stop();
  if (at.tokens.brackets_lost() && at.tokens.diagnostics().has_errors()) return true;
  if (at.tokens.frames().depth() == 0) {
    at.error("unexpected end of file: expected " + expected_text(at.expected));
    return true;
  }
  const bool brace = at.frame.opener == T::OPEN_BRACE;
  const std::string word = block_word(at.source, at.frame);
  const std::string whose = brace || is_transform(at.frame.owner) ? "this " + word : in_quotes(word);
  at.error(fmt::format("unexpected end of file: '{}' of {} is missing", brace ? "}" : ")", whose))
      .notes.push_back(at.opened_here(at.frame));
  return true;
}

}  // namespace trace::parser
