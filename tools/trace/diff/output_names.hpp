// That no result of `trace diff` takes the place of what is compared, or of another result.
#pragma once

#include <string>
#include <vector>

#include "tools/trace/diff/diff_arguments.hpp"
#include "tools/trace/diff/picture_pairs.hpp"

namespace trace {

// What is wrong with the names of the results, for people; empty where nothing is. A result may be neither a
// picture of `pairs`, nor the tolerance file, nor another result, whatever links and spelling of names lead
// there. Devices such as /dev/null keep nothing and may be given several times.
std::string output_conflict(const DiffArguments& arguments, bool folders, const std::vector<FilePair>& pairs);

}  // namespace trace
