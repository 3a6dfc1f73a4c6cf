#include "report/html.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "image/atomic_file.hpp"
#include "report/html_assets.hpp"
#include "report/html_pictures.hpp"
#include "report/html_text.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& object, const char* key) {
  const auto member = object.find(key);
  return member != object.end() && member->is_string() ? member->get<std::string>() : "";
}

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

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).parent_path();
}

}  // namespace

void write_html_report(const Json& report, const std::filesystem::path& file, const HtmlOptions& options) {
  if (!is_batch_report(report)) throw std::invalid_argument("not a batch report of version 1");

  AtomicFile target(file);
  const auto out = [&](std::string_view text) {
    target.write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  };
  html::Pictures pictures(options.embed_pictures, folder_of(file));
  const auto put = [&](std::string_view name) {
    if (name == "title") out(html::escape(text_of(report, "title")));
    if (name == "style") out(html::style());
    if (name == "libraries") out(html::libraries());
    if (name == "script") out(html::script());
    if (name == "report") out(html::script_json(with_places(report, pictures)));
    if (name == "pictures") pictures.write(out);  // last: the page can be used while they load
  };

  std::string_view rest = html::page();
  for (std::size_t mark; (mark = rest.find("{{")) != rest.npos;) {
    const std::size_t end = rest.find("}}", mark);
    out(rest.substr(0, mark));
    put(rest.substr(mark + 2, end - mark - 2));
    rest.remove_prefix(end + 2);
  }
  out(rest);
  target.commit();
}

}  // namespace trace
