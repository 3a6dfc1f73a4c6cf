// Results of hard cases as text.
#pragma once

#include <iosfwd>

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

struct Result {
  HardCase hard;
  std::vector<Row> rows;
  double seconds;
};

// One line a row, for the terminal.
void print_lines(std::ostream& out, const Result& result);

// "row form workload digest", one line for each row that has a digest: to be compared between builds by
// `cmp`.
void print_digests(std::ostream& out, const Result& result);

// A section a case: its promise, what is said of it, the table of its rows.
void print_markdown(std::ostream& out, const std::vector<Result>& results);

void print_json(std::ostream& out, const std::vector<Result>& results);

}  // namespace trace::hard
