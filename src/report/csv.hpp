// Comma-separated values: RFC 4180, with lines that end in LF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trace {

// As it stands in a row: in quotes where it holds a comma, a quote or a line end.
std::string csv_field(std::string_view text);

// One row with its line end.
std::string csv_row(const std::vector<std::string>& fields);

}  // namespace trace
