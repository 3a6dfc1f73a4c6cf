// What `trace diff` prints for people.
#pragma once

#include <string>

#include "report/diff_report.hpp"

namespace trace {

// Standard output is a terminal and the user has not asked for none by NO_COLOR (no-color.org).
bool colour_wanted();

// Everything that is known of one pair, in a block of lines.
std::string pair_text(const ComparedPair& pair, bool colour);

// One line a pair in the order of the report, then a line that counts the verdicts.
std::string folder_text(const DiffReport& report, bool colour);

// The verdict as words and the reason: "beyond tolerance: RMSE 3.2 is over 0.5". Without colour or line end.
std::string verdict_text(const Judgement& judgement);

}  // namespace trace
