// The reserved words of the scene language and the blocks they may stand in: the table behind the scanner,
// the recovery from errors and the suggestions.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "parser/token.hpp"

namespace trace::parser {

// The token of a reserved word; nothing for any other word. 'colour' is 'color' and 'polymesh' is 'trimesh'.
std::optional<Kind> reserved_word(std::string_view word);
bool is_reserved(std::string_view word);
// Whether it is the token of a word, reserved or of a dialect (the grammar lists them last).
bool is_keyword(Kind kind);

// The word of a kind of token, as one writes it: "sphere", "{".
std::string_view spelling(Kind kind);

bool is_primitive(Kind kind);
bool is_transform(Kind kind);
bool is_light(Kind kind);

// Blocks are named by the word that opens them; a group by OPEN_BRACE, the top level of a scene by END.
// The reserved words that begin a statement in such a block; those of dialects are in dialect_words.hpp.
const std::vector<Kind>& statements_of(Kind block);
// Both.
bool begins_statement(Kind block, Kind word);
// The same as text, for suggestions; and without synonyms and what only dialects say.
std::vector<std::string_view> statement_words(Kind block);
std::vector<std::string_view> usual_words(Kind block);

}  // namespace trace::parser
