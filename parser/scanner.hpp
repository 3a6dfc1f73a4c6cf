// Text to tokens, by Flex (scanner.ll). Lexical errors are reported here and never stop the reading.
#pragma once

#include <cstdint>
#include <memory>

#include "parser/diagnostic.hpp"
#include "parser/token.hpp"

namespace trace::parser {

class Scanner {
 public:
  // Both must outlive the scanner. Reading begins behind a UTF-8 byte-order mark.
  Scanner(const Source& source, Diagnostics& diagnostics);
  ~Scanner();

  // The next token; at the end of the text END, again and again.
  Token next();

  // Goes on at another place of the text.
  void seek(std::uint32_t offset);

  // While quiet, lexical errors are not reported.
  void set_quiet(bool quiet);

  // A string that does not end on its line was met since the scanner was set quiet: brackets may have been
  // lost in it.
  bool lost_text() const;

  struct State;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace trace::parser
