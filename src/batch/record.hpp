// What is known of a finished job: an object of the batch report's "results" (docs/batch.md), and besides,
// for going on later, "key", "judge_key", "inputs" and "picture_hash".
#pragma once

#include <nlohmann/json.hpp>

namespace trace {

using Record = nlohmann::ordered_json;

}  // namespace trace
