// The layout of messages: that of gcc and clang, one excerpt a place.
#include <fmt/format.h>

#include <algorithm>

#include "parser/diagnostic.hpp"
#include "parser/printable.hpp"

namespace trace::parser {

namespace {

constexpr std::size_t widest = 100;  // columns of an excerpt; longer lines are cut around the place
constexpr std::size_t lead = 60;     // of these, at most so many before the place
constexpr std::size_t tab = 4;

std::string head(const Source& source, Span span, std::string_view kind, std::string_view text) {
  const Position at = source.position(span.begin);
  return fmt::format("{}:{}:{}: {}: {}\n", source.name(), at.line, at.column, kind, text);
}

// The first byte of the excerpt: the line's begin, or a character's begin some way before the place.
std::size_t excerpt_begin(std::string_view line, std::size_t place, bool fits) {
  if (fits || place <= lead) return 0;
  std::size_t begin = place - lead;
  while (begin < place && (static_cast<unsigned char>(line[begin]) & 0xc0) == 0x80) ++begin;
  return begin;
}

// The source line and, below it, the caret line.
std::string excerpt(const Source& source, Span span) {
  const std::string_view line = source.line_at(span.begin);
  const std::size_t place = std::min<std::size_t>(span.begin - source.line_begin(span.begin), line.size());
  const std::size_t length = std::max<std::size_t>(span.end > span.begin ? span.end - span.begin : 1, 1);

  const std::size_t begin = excerpt_begin(line, place, line.size() <= widest);
  std::string shown = begin > 0 ? "..." : "";
  std::string carets;
  std::size_t column = shown.size();
  const auto mark = [&](std::size_t at, std::size_t columns) {
    const char fill = at < place ? ' ' : '~';
    if (at >= place + length) return;
    carets.append(column - carets.size(), ' ');
    carets.append(columns, fill);
    if (at == place) carets[column] = '^';
  };
  std::size_t at = begin;
  while (at < line.size() && column < widest) {
    PrintableCharacter c = printable_character(line, at);
    if (line[at] == '\t') c = {1, tab - column % tab, std::string(tab - column % tab, ' ')};
    mark(at, c.columns);
    shown += c.shown;
    column += c.columns;
    at += c.bytes;
  }
  if (place >= at) mark(place, 1);
  if (at < line.size()) shown += "...";
  return shown + "\n" + carets + "\n";
}

}  // namespace

std::string render(const Source& source, const Diagnostic& diagnostic) {
  const std::string_view kind = diagnostic.severity == Severity::error ? "error" : "warning";
  std::string result =
      head(source, diagnostic.span, kind, diagnostic.text) + excerpt(source, diagnostic.span);
  if (!diagnostic.suggestion.empty()) {
    result += head(source, diagnostic.span, "note", fmt::format("did you mean '{}'?", diagnostic.suggestion));
  }
  for (const Note& note : diagnostic.notes) {
    result += head(source, note.span, "note", note.text);
    if (note.span != diagnostic.span) result += excerpt(source, note.span);
  }
  return result;
}

std::string render(const Source& source, const Diagnostics& diagnostics) {
  std::string result;
  for (const Diagnostic& diagnostic : diagnostics.all()) result += render(source, diagnostic);
  if (diagnostics.error_count() > Diagnostics::limit) {
    result += fmt::format("{}: {} errors in all; the first {} are shown\n", source.name(),
                          diagnostics.error_count(), Diagnostics::limit);
  }
  return result;
}

}  // namespace trace::parser
