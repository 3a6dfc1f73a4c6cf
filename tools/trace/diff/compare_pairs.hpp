// Judges all pairs of `trace diff`.
#pragma once

#include <string>
#include <vector>

#include "report/diff_report.hpp"
#include "tools/trace/diff/diff_arguments.hpp"
#include "tools/trace/diff/picture_pairs.hpp"
#include "tools/trace/tolerances.hpp"

namespace trace {

// In the order of `pairs`; several pairs are compared on all cores. Heat maps are written as they are found:
// of folders to NAME.heat.png in the folder of heat maps, with the same layout. Where there is nothing to
// show, a heat map left there by an earlier run is removed. What cannot be written is told in `failures`,
// whole sentences; throws ImageError where no heat map could be written at all.
std::vector<ComparedPair> compare_pairs(const std::vector<FilePair>& pairs, const DiffArguments& arguments,
                                        bool folders, const Tolerances& tolerances,
                                        std::vector<std::string>& failures);

}  // namespace trace
