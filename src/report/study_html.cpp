#include "report/study_html.hpp"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "report/html_assets.hpp"
#include "report/html_page.hpp"
#include "report/html_pictures.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;
using html::text_of;

// Where the page finds what it mentions.
class Places {
 public:
  Places(const NamedPictures& named, html::Pictures& embedded) : named_(named), embedded_(embedded) {}

  Json of(const std::string& name) {
    const auto found = named_.find(name);
    return found == named_.end() ? embedded_.place(std::filesystem::path(name))
                                 : embedded_.place(found->second);
  }

  // Of the members of `object` with these keys that are there.
  Json of(const Json& object, std::initializer_list<const char*> keys) {
    Json places = Json::object();
    for (const char* key : keys)
      if (const std::string name = text_of(object, key); !name.empty()) places[key] = of(name);
    return places;
  }

 private:
  const NamedPictures& named_;
  html::Pictures& embedded_;
};

// The report as the page reads it: each scene and each result with "places" of its pictures.
Json with_places(const Json& report, Places places) {
  Json page = report;
  for (Json& scene : page.at("scenes")) {
    Json own = places.of(scene, {"solution"});
    if (const std::string name = text_of(scene.at("converged"), "picture"); !name.empty())
      own["converged"] = places.of(name);
    scene["places"] = std::move(own);
    for (Json& result : scene.at("results")) result["places"] = places.of(result, {"picture", "heat"});
  }
  return page;
}

bool is_study(const Json& report) {
  return report.is_object() && text_of(report, "format") == "trace-study" &&
         report.value("version", 0) == 1 && report.contains("scenes") && report["scenes"].is_array();
}

}  // namespace

void write_study_report(const Json& report, const NamedPictures& pictures,
                        const std::filesystem::path& file) {
  if (!is_study(report)) throw std::invalid_argument("not a study of version 1");
  html::Pictures embedded(true, html::folder_of(file));
  const html::Page page{text_of(report, "title"), "trace study --json and --csv give the same figures.",
                        html::study_style(), html::study_script()};
  html::write_page(page, with_places(report, Places(pictures, embedded)), embedded, file);
}

}  // namespace trace
