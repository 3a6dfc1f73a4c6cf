// The brackets that are open at a place of the text, and what each belongs to. Messages say from it where one
// is; the recovery from an error finds the end of the statement with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "parser/token.hpp"

namespace trace::parser {

struct Frame {
  Kind opener = T::END;  // OPEN_BRACE, OPEN_PAREN; END for the whole scene
  // The word the bracket belongs to: a primitive, light, camera or MATERIAL; a transform; an attribute whose
  // value it is. OPEN_BRACE for a group, END for the scene, LIST for a row of a matrix, WORD for what is not
  // known.
  Kind owner = T::END;
  Span owner_span;
  Span open_span;
  // The statement of this block that is being read: its first word. END between statements.
  Kind statement = T::END;
  Span statement_span;
  std::uint32_t commas = 0;  // so far, directly inside

  bool is_block() const { return opener != T::OPEN_PAREN; }
};

class Frames {
 public:
  Frames() { frames_.emplace_back(); }

  // A token that the grammar has taken.
  void apply(const Token& token);
  // A PLAIN_MATERIALS that the grammar has taken: whole entries, and the ',' behind the last of them.
  void pass_materials(const Token& materials);

  const Frame& top() const { return frames_.back(); }
  const Frame& parent() const { return frames_[frames_.size() < 2 ? 0 : frames_.size() - 2]; }
  std::size_t depth() const { return frames_.size() - 1; }
  // The innermost block, which is where the reading goes on after an error.
  std::size_t block_depth() const;
  const Frame& at(std::size_t depth) const { return frames_[depth]; }
  // Open groups and transforms.
  std::size_t nesting() const { return nesting_; }

  // A token that is passed over while looking for the next statement of the block at `depth`. True if it is
  // where the reading goes on: the first word of a statement, a ';', the '}' of that block, or a
  // word or (where groups may stand) a '{' behind a bracket, which most likely is meant for a statement too.
  bool skip(const Token& token, std::size_t depth);
  // A word that is passed over although a statement might begin with it.
  void pass_word(const Token& word);
  // Whether a closing bracket without its partner was passed over, or brackets were closed for want of one.
  bool bracket_lost() const { return bracket_lost_; }

  const Token& last() const { return last_; }  // the token taken last
  const Token& before_last() const { return before_last_; }

 private:
  void open(const Token& token);
  void close();
  bool skip_brace(std::size_t depth);
  bool only_values_above(std::size_t depth) const;

  std::vector<Frame> frames_;
  Token last_, before_last_;
  std::size_t nesting_ = 0;
  bool bracket_lost_ = false;
};

}  // namespace trace::parser
