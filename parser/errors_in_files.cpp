// Errors at the header and at the end of the file.
#include <fmt/format.h>

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
    std::vector<std::string> parts;
    for (const Kind kind : at.expected) parts.push_back(expected_text(kind));
    at.error("unexpected end of file: expected " + enumeration(parts, "or"));
    return true;
  }
  const std::string bracket = at.frame.opener == T::OPEN_BRACE ? "}" : ")";
  at.error(fmt::format("unexpected end of file: '{}' of this {} is missing", bracket,
                       block_word(at.source, at.frame)))
      .notes.push_back(at.opened_here(at.frame));
  return true;
}

}  // namespace trace::parser
