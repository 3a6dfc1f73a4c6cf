// The words that dialects add to the language. They are words of the language only where a statement of the
// block that takes them begins; anywhere else they are names like others, so that no scene of the core
// language reads differently for them.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "parser/token.hpp"

namespace trace::parser {

struct DialectWord {
  std::string_view word;
  Kind kind;
  bool usual = true;  // ours, as told in messages; the others are what some project calls the same or similar
};

// Of a block, named as in vocabulary.hpp.
const std::vector<DialectWord>& dialect_words(Kind block);

// The entry of a word in such a block; null where it is none there.
const DialectWord* find_dialect_word(Kind block, std::string_view word);
// What it begins there.
std::optional<Kind> dialect_word(Kind block, std::string_view word);

}  // namespace trace::parser
