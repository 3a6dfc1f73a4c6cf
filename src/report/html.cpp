#include "report/html.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "report/html_assets.hpp"
#include "report/html_page.hpp"
#include "report/html_pictures.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;
using html::text_of;

bool identical(const Json& result) {
  const auto comparison = result.find("comparison");
  return comparison != result.end() && comparison->is_object() &&
         text_of(*comparison, "verdict") == "identical";
}

// The report as the page reads it: each result with "places" of its pictures.
Json with_places(const Json& report, html::Pictures& pictures) {
  Json page = report;
  for (Json& result : page.at("results")) {
    Json places = Json::object();
    for (const char* role : {"picture", "solution", "heat"}) {
      const std::string name = text_of(result, role);
      if (name.empty()) continue;
      const bool same =
          role == std::string_view("solution") && identical(result) && places.contains("picture");
      places[role] = same ? places["picture"] : pictures.place(name);
    }
    result["places"] = std::move(places);
  }
  return page;
}

bool is_batch_report(const Json& report) {
  return report.is_object() && text_of(report, "format") == "trace-batch" &&
         report.value("version", 0) == 1 && report.contains("results") && report["results"].is_array();
}

}  // namespace

void write_html_report(const Json& report, const std::filesystem::path& file, const HtmlOptions& options) {
  if (!is_batch_report(report)) throw std::invalid_argument("not a batch report of version 1");
  html::Pictures pictures(options.embed_pictures, html::folder_of(file));
  const html::Page page{text_of(report, "title"), "The same results are in results.json.",
                        html::batch_style(), html::batch_script()};
  html::write_page(page, with_places(report, pictures), pictures, file);
}

}  // namespace trace
