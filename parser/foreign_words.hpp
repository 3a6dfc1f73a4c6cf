// Words of dialects that this language leaves out on purpose: what their error says of them.
#pragma once

#include <string_view>

namespace trace::parser {

// "is an extension of some HKUST projects (implicit surfaces)"; empty for a word that is not known.
std::string_view foreign_word(std::string_view word);

}  // namespace trace::parser
