// What is known of a finished job: an object of the batch report's "results" (docs/batch.md), and besides,
// for going on later, the members of internal_members.
#pragma once

#include <nlohmann/json.hpp>

namespace trace {

using Record = nlohmann::ordered_json;

inline constexpr const char* internal_members[] = {"key", "judge_key", "inputs", "picture_hash",
                                                   "drawing_message"};

// As one line of text. What is not UTF-8 is replaced.
inline std::string to_text(const Record& record, int indent = -1) {
  return record.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace trace
