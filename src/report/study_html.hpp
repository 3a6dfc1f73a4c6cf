// The report of a study as a page for people: one HTML file that needs no network and opens from disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace trace {

// Pictures by the name under which the report mentions them: PNG files as bytes.
using NamedPictures = std::map<std::string, std::vector<std::uint8_t>>;

// `report` is as docs/schemas/study-1.schema.json says. All pictures that it mentions are embedded, each of
// the same bytes once. A name that is not in `pictures` (that of a solution) is a file's, relative to the
// current directory; one that is missing or cannot be read is told of in its place.
//
// The file is replaced whole or left as it was (AtomicFile). Throws ImageError where it cannot be written,
// std::invalid_argument where `report` is no study of version 1.
void write_study_report(const nlohmann::ordered_json& report, const NamedPictures& pictures,
                        const std::filesystem::path& file);

}  // namespace trace
