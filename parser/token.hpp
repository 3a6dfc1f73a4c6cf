// One token of a scene file. Its text is what the source holds at its span.
#pragma once

#include <cstdint>

#include "grammar.hpp"  // generated from grammar.yy
#include "parser/source.hpp"

namespace trace::parser {

using Kind = bison::Grammar::token_kind_type;
using T = bison::Grammar::token;

struct Token {
  Kind kind = T::END;
  Span span;
  double number = 0;         // of a NUMBER
  bool after_error = false;  // the scanner has reported this token or what stands before it
};

}  // namespace trace::parser
