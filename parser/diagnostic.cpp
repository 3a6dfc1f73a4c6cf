#include "parser/diagnostic.hpp"

#include <utility>

namespace trace::parser {

Diagnostic& Diagnostics::error(Span span, std::string text) {
  ++error_count_;
  return add(Severity::error, span, std::move(text));
}

Diagnostic& Diagnostics::warning(Span span, std::string text) {
  return add(Severity::warning, span, std::move(text));
}

Diagnostic& Diagnostics::add(Severity severity, Span span, std::string text) {
  const bool full = list_.size() >= 2 * limit || (severity == Severity::error && error_count_ > limit);
  Diagnostic& place = full ? overflow_ : list_.emplace_back();
  place = {severity, span, std::move(text), {}, {}};
  return place;
}

}  // namespace trace::parser
