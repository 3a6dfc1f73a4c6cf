// Text to description: the whole interface of the parser.
#pragma once

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "parser/source.hpp"

namespace trace::parser {

// Deepest nesting of transforms and groups that is accepted.
inline constexpr std::size_t max_nesting = 100'000;

struct ParseOptions {
  Dialect dialect = Dialect::utexas;
  bool permissive = false;  // unknown blocks and attributes are passed over with a warning each
};

// What is wrong is added to `diagnostics`, several errors in one run; the result is complete only if it has
// none afterwards. Never throws for what the text says; std::bad_alloc may pass.
Scene parse(const Source& source, Diagnostics& diagnostics, const ParseOptions& options = {});

}  // namespace trace::parser
