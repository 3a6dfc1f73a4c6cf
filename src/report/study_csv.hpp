// The results of a study as a table: a row a scene and setting.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace trace {

// `report` is as docs/schemas/study-1.schema.json says. RFC 4180 with lines that end in LF, the first row
// names the columns: times in milliseconds, errors in levels (1/255), memory in bytes. What is not known is
// an empty field.
std::string study_csv(const nlohmann::ordered_json& report);

}  // namespace trace
