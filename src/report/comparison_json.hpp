// One judgement as JSON: docs/schemas/comparison-1.schema.json. The members of `trace diff --json` pairs, of
// the batch's results and of the report are these.
#pragma once

#include <nlohmann/json.hpp>

#include "comparison/judge.hpp"

namespace trace {

// JSON knows neither NaN nor infinity: what is not finite (the PSNR of equal pictures) is null.
nlohmann::ordered_json comparison_json(const Judgement& judgement);

}  // namespace trace
