// The scanner's tokens as the grammar takes them. It keeps the open brackets, reads the long lists of meshes
// in one piece (list_reader.hpp) and leads the grammar on after an error.
//
// How an error is recovered from: Bison reports it, drops its stack down to the innermost list of statements
// and calls recover(), which passes over tokens, brackets counted, up to the next statement of that list. The
// token in hand is kept if it begins one. So one slip is one error, and every token is looked at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "parser/frames.hpp"
#include "parser/list_reader.hpp"
#include "parser/scanner.hpp"

namespace trace::parser {

class Builder;

enum class Recovery { keep, drop, stop };

class TokenStream {
 public:
  // `permissive`: unknown words are warned of, and what they begin is passed over.
  TokenStream(const Source& source, Diagnostics& diagnostics, Builder& builder, bool permissive);

  // For the grammar.
  bison::Grammar::symbol_type next();
  Recovery recover();

  // For messages: the token that was returned last and is not yet taken, and what stood before it.
  const Token& current() const { return current_; }
  const Frames& frames() const { return frames_; }
  const Source& source() const { return source_; }
  Diagnostics& diagnostics() { return diagnostics_; }
  bool permissive() const { return permissive_; }
  bool brackets_lost() const { return frames_.bracket_lost() || scanner_.lost_text(); }

  // Called while an error is reported: the '}' of the innermost block is missing in front of the current
  // token.
  void insert_brace() { insert_brace_ = true; }
  // Likewise: the bracket that should open here is missing, what follows stands in it all the same.
  void assume_open(Kind bracket) { assumed_open_ = bracket; }
  // Nothing more is read and nothing more reported.
  void stop() { stopped_ = true; }
  bool stopped() const { return stopped_; }
  // Whether this is the first time that it is told what such a block takes.
  bool first_note(Kind block);
  // The error that is being reported stands at a word that cannot be meant as the next statement.
  void drop_current() { drop_current_ = true; }

 private:
  // The scanner's next token; a word of a dialect where it is one.
  Token scan();
  Kind dialect_kind(const Token& word) const;
  Token advance();
  Token skip();
  Token read_list(const Token& open);
  Token read_plain_materials(const Token& open);
  bool at_vertex_material(const Token& token) const;
  Token leave_list(const Token& found, const ListStop& stop);
  void check_nesting(const Token& token);
  bison::Grammar::symbol_type symbol(const Token& token) const;

  const Source& source_;
  Diagnostics& diagnostics_;
  Builder& builder_;
  bool permissive_;
  Scanner scanner_;
  Frames frames_;
  Token current_;
  std::vector<Token> held_;  // come before the scanner's, the last one first
  std::size_t target_ = 0;   // depth of the block that is being recovered
  std::optional<std::uint32_t> last_error_;
  std::vector<Kind> noted_;
  std::optional<Kind> assumed_open_;
  bool taken_ = false;  // whether the grammar takes the current token
  bool skipping_ = false, stopped_ = false;
  bool insert_brace_ = false, drop_current_ = false, silence_next_ = false;
};

}  // namespace trace::parser
