// Messages about the lists of points, normals and faces.
#pragma once

#include "parser/list_reader.hpp"
#include "parser/token_stream.hpp"

namespace trace::parser {

// `open` is the list's '(', `found` the token that stands where `need` should. The list is that of the
// attribute the stream has just taken.
void report_list_error(TokenStream& tokens, Span open, ListNeed need, const Token& found);

}  // namespace trace::parser
