// Warnings of one kind of which a file can cause any number: the first few are given, the rest is counted.
#pragma once

#include <string>

#include "parser/diagnostic.hpp"

namespace trace {

class FewWarnings {
 public:
  static constexpr std::size_t most = 5;

  // `rest` says how many more there are, with {} for the number: at least two, for one more is given as it
  // is.
  FewWarnings(parser::Diagnostics& diagnostics, std::string rest)
      : diagnostics_(diagnostics), rest_(std::move(rest)) {}
  ~FewWarnings();
  FewWarnings(const FewWarnings&) = delete;
  FewWarnings& operator=(const FewWarnings&) = delete;

  void add(parser::Span span, const std::string& text);

 private:
  parser::Diagnostics& diagnostics_;
  std::string rest_;
  std::size_t count_ = 0;
  parser::Diagnostic held_;  // the first beyond `most`
};

}  // namespace trace
