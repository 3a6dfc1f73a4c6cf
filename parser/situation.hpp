// What is known where a syntax error is found, for the functions that put it into words. Each of them returns
// whether it knew the case and has reported it; syntax_error.cpp asks them in order.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "parser/frames.hpp"
#include "parser/token_stream.hpp"
#include "parser/wording.hpp"

namespace trace::parser {

struct Situation {
  TokenStream& tokens;
  const std::vector<Kind>& expected;
  const Source& source;
  const Frame& frame;  // the innermost bracket
  const Token& found;  // the token that cannot stand here
  const Token& last;   // the one before it
  const Token& before_last;

  bool expects(Kind kind) const {
    return std::find(expected.begin(), expected.end(), kind) != expected.end();
  }
  bool expects_only(Kind kind) const { return expected.size() == 1 && expected.front() == kind; }
  bool expects_object() const { return expects(Kind::SPHERE); }
  std::string_view text(const Token& token) const { return text_of(source, token.span); }
  std::string found_text() const { return parser::found_text(source, found); }
  bool found_word() const;  // reserved or not
  Kind found_kind() const;  // of a word of a dialect, what it is at the top level of a scene

  Diagnostic& error(std::string message) const;               // at the found token
  Diagnostic& error_found(const std::string& message) const;  // the same with ", found 'x'"
  void suggest(Diagnostic& diagnostic, Kind block) const;     // a statement of the block that looks alike
  Note opened_here(const Frame& opened) const;
  // Whether the error of an unknown word goes with what is known there: not where it is passed over, nor
  // where the word is known to be another language's.
  bool lists_words() const;
  // A word that nothing here begins with: `what` as in "attribute", `where` as in " in a sphere".
  Diagnostic& unknown(std::string_view what, const std::string& where, Kind block) const;
};

// errors_in_files.cpp: the header and the end of the file.
bool explain_header(const Situation& at);
bool explain_end_of_file(const Situation& at);
// errors_in_blocks.cpp: what begins or ends a statement.
bool explain_missing_equals(const Situation& at);
bool explain_missing_semicolon(const Situation& at);
bool explain_attribute(const Situation& at);
bool explain_object(const Situation& at);
bool explain_transform(const Situation& at);
bool explain_opening(const Situation& at);
// errors_in_values.cpp: right-hand sides and what is in their parentheses.
bool explain_string_escape(const Situation& at);
bool explain_name(const Situation& at);
bool explain_value(const Situation& at);
bool explain_tuple(const Situation& at);

}  // namespace trace::parser
