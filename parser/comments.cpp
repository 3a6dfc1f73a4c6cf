#include "parser/comments.hpp"

#include <cstring>

namespace trace::parser {

const char* line_comment_end(const char* at, const char* end) {
  while (at < end && *at != '\n' && *at != '\r') ++at;
  return at;
}

const char* block_comment_end(const char* at, const char* end) {
  while (at < end) {
    const auto* star = static_cast<const char*>(std::memchr(at, '*', static_cast<std::size_t>(end - at)));
    if (star == nullptr) return nullptr;
    if (star[1] == '/') return star + 2;
    at = star + 1;
  }
  return nullptr;
}

const char* skip_blanks(const char* at, const char* end) {
  for (;;) {
    while (is_blank(*at)) ++at;
    if (at[0] != '/') return at;
    if (at[1] == '/') {
      at = line_comment_end(at + 2, end);
    } else if (at[1] == '*') {
      const char* const behind = block_comment_end(at + 2, end);
      if (behind == nullptr) return at;
      at = behind;
    } else {
      return at;
    }
  }
}

}  // namespace trace::parser
