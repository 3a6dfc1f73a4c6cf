/* Tokens of the scene language. Flex reads the text in pieces through YY_INPUT; places are counted here, by
   the length of what each rule matched. What may be long (comments, strings, runs of digits or letters) is
   followed to its end on the text itself, so that no token is ever copied or rescanned as a whole. */
%option reentrant noyywrap nounput noinput 8bit nodefault never-interactive nostdinit
%option prefix="trace_scanner_"
%option extra-type="trace::parser::Scanner::State*"

%top{
// The scanner; see scanner.hpp.
#include <algorithm>
#include <cstring>
#include <string>

#include "parser/comments.hpp"
#include "parser/number.hpp"
#include "parser/printable.hpp"
#include "parser/scanner.hpp"
#include "parser/vocabulary.hpp"
}

%{
namespace trace::parser {

// Flex's handle, freed with the state.
class FlexHandle {
 public:
  explicit FlexHandle(Scanner::State* state);
  FlexHandle(const FlexHandle&) = delete;
  FlexHandle& operator=(const FlexHandle&) = delete;
  ~FlexHandle();
  yyscan_t get() const { return handle_; }

 private:
  yyscan_t handle_ = nullptr;
};

struct Scanner::State {
  State(const Source& text_source, Diagnostics& found)
      : text(text_source.text()), diagnostics(found), flex(this) {}

  std::string_view text;
  Diagnostics& diagnostics;
  std::size_t cursor = 0;     // what Flex asks for next
  std::size_t piece = 256;    // how much it then gets: little after a seek, doubling up to a block
  std::uint32_t begin = 0, end = 0;  // of the token in hand
  double number = 0;
  bool quiet = false;
  bool after_error = false;
  bool lost_text = false;
  FlexHandle flex;

  const char* at(std::uint32_t offset) const { return text.data() + offset; }
  const char* text_end() const { return text.data() + text.size(); }
  std::uint32_t offset_of(const char* place) const { return static_cast<std::uint32_t>(place - text.data()); }

  int give(char* buffer, std::size_t room) {
    const std::size_t count = std::min({room, piece, text.size() - cursor});
    std::memcpy(buffer, text.data() + cursor, count);
    cursor += count;
    piece = std::min<std::size_t>(piece * 2, 8192);
    return static_cast<int>(count);
  }

  void error(Span span, std::string message) {
    after_error = true;
    if (!quiet) diagnostics.error(span, std::move(message));
  }

  void go_to(std::uint32_t offset);
  void block_comment();
  void string();
  void read_number_at();
  Kind word();
  void unexpected();
};

}  // namespace trace::parser

#define YY_INPUT(buffer, result, room) (result) = yyextra->give(buffer, static_cast<std::size_t>(room))
#define YY_USER_ACTION                \
  yyextra->begin = yyextra->end;      \
  yyextra->end += static_cast<std::uint32_t>(yyleng);
#define YY_DECL int trace_scanner_lex(yyscan_t yyscanner)

using trace::parser::T;
%}

%%

[ \t\r\n\f\v]{1,32}            { /* blank */ }
"//"                           { yyextra->go_to(yyextra->offset_of(trace::parser::line_comment_end(
                                     yyextra->at(yyextra->end), yyextra->text_end()))); }
"/*"                           { yyextra->block_comment(); }

"{"                            { return T::OPEN_BRACE; }
"}"                            { return T::CLOSE_BRACE; }
"("                            { return T::OPEN_PAREN; }
")"                            { return T::CLOSE_PAREN; }
","                            { return T::COMMA; }
"="                            { return T::EQUALS; }
";"                            { return T::SEMICOLON; }

[A-Za-z_][A-Za-z0-9_-]{0,47}   { return yyextra->word(); }
[-+.0-9][-+.0-9eE]{0,47}       { yyextra->read_number_at(); return T::NUMBER; }
"\""                           { yyextra->string(); return T::STRING; }

.|\n                           { yyextra->unexpected(); }
<<EOF>>                        { yyextra->begin = yyextra->end; return T::END; }

%%

namespace trace::parser {

FlexHandle::FlexHandle(Scanner::State* state) { trace_scanner_lex_init_extra(state, &handle_); }
FlexHandle::~FlexHandle() { trace_scanner_lex_destroy(handle_); }

// Where the rule matched just as much as there is, Flex goes on by itself; otherwise its buffer is emptied.
void Scanner::State::go_to(std::uint32_t offset) {
  if (offset == end && cursor != 0) return;
  end = offset;
  cursor = offset;
  piece = 256;
  trace_scanner_restart(nullptr, flex.get());
}

void Scanner::State::block_comment() {
  const char* const behind = block_comment_end(at(end), text_end());
  if (behind == nullptr) error({begin, end}, "this comment is not closed: its '*/' is missing");
  go_to(behind == nullptr ? static_cast<std::uint32_t>(text.size()) : offset_of(behind));
}

void Scanner::State::string() {
  const std::size_t stop = std::min(text.find_first_of("\"\r\n", end), text.size());
  if (stop < text.size() && text[stop] == '"') return go_to(static_cast<std::uint32_t>(stop + 1));
  error({begin, static_cast<std::uint32_t>(stop)}, "this string is not closed on its line");
  lost_text = true;
  // A string broken over two lines leaves an odd quote on the second: it ends there.
  std::size_t line = stop;
  while (line < text.size() && is_blank(text[line])) ++line;
  const std::size_t line_end = std::min(text.find_first_of("\r\n", line), text.size());
  const std::string_view next = text.substr(line, line_end - line);
  const bool odd = std::count(next.begin(), next.end(), '"') % 2 == 1;
  go_to(static_cast<std::uint32_t>(odd ? line + next.find('"') + 1 : stop));
}

void Scanner::State::read_number_at() {
  const NumberText read = read_number(at(begin), text_end());
  number = read.value;
  const Span span{begin, offset_of(read.end)};
  const std::string_view run = text.substr(span.begin, span.end - span.begin);
  if (read.state == NumberState::malformed) error(span, "malformed number " + in_quotes(run));
  if (read.state == NumberState::out_of_range) error(span, "number " + in_quotes(run) + " is out of range");
  go_to(span.end);
}

Kind Scanner::State::word() {
  const char* behind = at(end);
  while (continues_word(*behind)) ++behind;
  go_to(offset_of(behind));
  return reserved_word(text.substr(begin, end - begin)).value_or(T::WORD);
}

// A run of characters that nothing begins with is one error.
void Scanner::State::unexpected() {
  if (text.substr(begin, 2) == "*/") {
    error({begin, begin + 2}, "'*/' without '/*': comments do not nest");
    return go_to(begin + 2);
  }
  const std::size_t length = std::max<std::size_t>(utf8_length(text, begin), 1);
  error({begin, begin + static_cast<std::uint32_t>(length)}, "unexpected character " + character_name(text, begin));
  const auto known = [this](char c) {
    return is_blank(c) || begins_word(c) || begins_number(c) || std::strchr("{}(),=;\"/", c) != nullptr;
  };
  std::size_t stop = begin + length;
  while (stop < text.size() && (text[stop] == '\0' || !known(text[stop]))) ++stop;
  // What follows a '#' is most likely meant for a comment.
  if (text[begin] == '#') stop = std::min(text.find_first_of("\r\n", begin), text.size());
  go_to(static_cast<std::uint32_t>(stop));
}

Scanner::Scanner(const Source& source, Diagnostics& diagnostics)
    : state_(std::make_unique<State>(source, diagnostics)) {
  if (state_->text.substr(0, 3) == "\xEF\xBB\xBF") seek(3);
}

Scanner::~Scanner() = default;

Token Scanner::next() {
  const auto kind = static_cast<Kind>(trace_scanner_lex(state_->flex.get()));
  const Token token{kind, {state_->begin, state_->end}, state_->number, state_->after_error};
  state_->after_error = false;
  return token;
}

void Scanner::seek(std::uint32_t offset) { state_->go_to(offset); }

void Scanner::set_quiet(bool quiet) { state_->quiet = quiet; }

bool Scanner::lost_text() const { return state_->lost_text; }

}  // namespace trace::parser
