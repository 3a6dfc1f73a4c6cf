// Where a comment ends. The text is followed by NUL bytes (see source.hpp).
#pragma once

namespace trace::parser {

// `at` is behind "//": the end of the line (LF, CR or the end of the text), which is not part of the comment.
const char* line_comment_end(const char* at, const char* end);

// `at` is behind "/*": behind the next "*/", or null where there is none. Comments do not nest.
const char* block_comment_end(const char* at, const char* end);

// Behind blanks (space, tab, LF, CR, form feed, vertical tab) and comments. Stops in front of a comment that
// is not closed.
const char* skip_blanks(const char* at, const char* end);

inline bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace trace::parser
