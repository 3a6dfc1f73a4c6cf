// Errors, warnings and notes about a scene, each with its place.
//
//   scene.ray:12:5: error: unknown attribute 'difuse' in a material
//       difuse=(1,0,0);
//       ^~~~~~
//   scene.ray:12:5: note: did you mean 'diffuse'?
//
// The text of every message is an interface: tests assert it word for word.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source.hpp"

namespace trace::parser {

enum class Severity { error, warning };

struct Note {
  Span span;
  std::string text;
};

struct Diagnostic {
  Severity severity = Severity::error;
  Span span;
  std::string text;
  std::string suggestion;  // a word to write instead; empty where there is none
  std::vector<Note> notes;
};

// Collects what is found about one source, in the order it is found. At most `limit` errors are kept; the
// rest are only counted, and the report says how many there were.
class Diagnostics {
 public:
  static constexpr std::size_t limit = 20;

  Diagnostic& error(Span span, std::string text);
  Diagnostic& warning(Span span, std::string text);

  bool has_errors() const { return error_count_ > 0; }
  std::size_t error_count() const { return error_count_; }
  const std::vector<Diagnostic>& all() const { return list_; }

 private:
  Diagnostic& add(Severity severity, Span span, std::string text);

  std::vector<Diagnostic> list_;
  Diagnostic overflow_;  // what is written to once the limit is reached
  std::size_t error_count_ = 0;
};

// The message with its source line (trimmed around the place when long), a caret span, suggestion and notes.
// Ends with a newline. Control characters and invalid UTF-8 of the scene never reach the terminal raw.
std::string render(const Source& source, const Diagnostic& diagnostic);
std::string render(const Source& source, const Diagnostics& diagnostics);

// The candidate nearest to `word` by edit distance where it is near enough to be a likely slip; else "".
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace trace::parser
