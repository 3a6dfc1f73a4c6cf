#include "scene/few_warnings.hpp"

#include <fmt/format.h>

namespace trace {

void FewWarnings::add(parser::Span span, const std::string& text) {
  ++count_;
  if (count_ <= most) {
    diagnostics_.warning(span, text);
  } else if (count_ == most + 1) {
    held_.span = span;
    held_.text = text;
  }
}

FewWarnings::~FewWarnings() {
  if (count_ <= most) return;
  const std::size_t rest = count_ - most;
  diagnostics_.warning(held_.span, rest == 1 ? held_.text : fmt::format(fmt::runtime(rest_), rest));
}

}  // namespace trace
