#include "parser/parse.hpp"

#include "parser/builder.hpp"
#include "parser/token_stream.hpp"

namespace trace::parser {

Scene parse(const Source& source, Diagnostics& diagnostics, const ParseOptions& options) {
  Builder builder(source, diagnostics, options.dialect, options.permissive);
  TokenStream tokens(source, diagnostics, builder, options.permissive);
  bison::Grammar grammar(tokens, builder);
  grammar.parse();
  return builder.take();
}

}  // namespace trace::parser
