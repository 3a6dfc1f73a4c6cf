// Syntax errors in the language's own words. Bison says which tokens could have stood at the place (exactly,
// by LAC); the open brackets say what was being read there.
#pragma once

#include <vector>

#include "parser/token_stream.hpp"

namespace trace::parser {

// Reports the stream's current token, where one of `expected` should stand, unless it only follows from an
// error reported already.
void report_syntax_error(TokenStream& tokens, const std::vector<Kind>& expected);

// Where `found` is a word that stands directly behind a number, reports both as one malformed number.
bool report_glued_number(const Source& source, const Token& found, Diagnostics& diagnostics);

}  // namespace trace::parser
