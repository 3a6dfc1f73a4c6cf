// The results of a study over all scenes as a picture.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace trace {

// `report` is as docs/schemas/study-1.schema.json says. An SVG 1.1 document: time against error, geometric
// means over the scenes relative to the first setting, both axes logarithmic; a shape and colour an axis, the
// front filled, joined and named. Where there is no error it is drawn below all others, as such. Colours
// follow prefers-color-scheme.
std::string study_svg(const nlohmann::ordered_json& report);

}  // namespace trace
