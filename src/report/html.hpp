// The report of a batch as a page for people: one HTML file that needs no network and opens from disk.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace trace {

struct HtmlOptions {
  bool embed_pictures = true;  // false: they are linked, relative to the page's folder
};

// `report` is the batch report ("format": "trace-batch", version 1); names of pictures in it are relative to
// the current directory. A picture that occurs more than once, or whose solution has the verdict "identical",
// is embedded once. PNG files are embedded as they are; other kinds become PNG (also when linking, where
// browsers cannot show them). A picture that is missing or cannot be read is told of in its place.
//
// One picture is in memory at a time. The file is replaced whole or left as it was (AtomicFile). Throws
// ImageError where it cannot be written, std::invalid_argument where `report` is no batch report.
void write_html_report(const nlohmann::ordered_json& report, const std::filesystem::path& file,
                       const HtmlOptions& options = {});

}  // namespace trace
