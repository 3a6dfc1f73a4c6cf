#include "parser/parse.hpp"

#include "parser/builder.hpp"
#include "parser/token_stream.hpp"

namespace trace::parser {

Scene parse(const Source& source, Diagnostics& diagnostics) {
  Builder builder(source, diagnostics);
  TokenStream tokens(source, diagnostics, builder);
  bison::Grammar grammar(tokens, builder);
  grammar.parse();
  return builder.take();
}

}  // namespace trace::parser
