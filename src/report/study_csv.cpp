#include "report/study_csv.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/csv.hpp"
#include "report/plain_text.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;

struct Column {
  const char* name;
  const char* pointer;  // within the object that it is of
};

constexpr Column of_scene[] = {{"scene", "/scene"},
                               {"width", "/width"},
                               {"height", "/height"},
                               {"depth", "/depth"},
                               {"converged_samples", "/converged/samples"},
                               {"converged_error", "/converged/error"}};
constexpr Column of_setting[] = {{"setting", "/name"}, {"axis", "/axis"}, {"options", "/options"}};
constexpr Column of_result[] = {{"ms", "/ms/median"},
                                {"ms_low", "/ms/low"},
                                {"ms_high", "/ms/high"},
                                {"runs", "/ms/runs"},
                                {"rms", "/error/rms"},
                                {"rms_uncertainty", "/error/uncertainty"},
                                {"mean_error", "/error/mean"},
                                {"largest_error", "/error/largest"},
                                {"against", "/error/against"},
                                {"solution_rms", "/solution/rms"},
                                {"solution_percent_over_one", "/solution/off_by_more_than_one"},
                                {"primary_rays", "/rays/primary"},
                                {"reflected_rays", "/rays/reflected"},
                                {"refracted_rays", "/rays/refracted"},
                                {"shadow_rays", "/rays/shadow"},
                                {"memory", "/memory"},
                                {"front", "/front"},
                                {"gain_over", "/gain/over"},
                                {"gain_ms", "/gain/ms"},
                                {"gain_rms", "/gain/rms"},
                                {"same_picture", "/same_picture"}};

std::string field(const Json& value) {
  if (value.is_string()) return valid_utf8(value.get<std::string>());
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return value.is_null() ? "" : value.dump();
}

std::string field(const Json& object, const char* pointer) {
  const Json::json_pointer place(pointer);
  return object.contains(place) ? field(object.at(place)) : "";
}

template <std::size_t N>
void add(std::vector<std::string>& row, const Json& object, const Column (&columns)[N]) {
  for (const Column& column : columns) row.push_back(field(object, column.pointer));
}

template <std::size_t N>
void add_names(std::vector<std::string>& row, const Column (&columns)[N]) {
  for (const Column& column : columns) row.emplace_back(column.name);
}

}  // namespace

std::string study_csv(const Json& report) {
  std::map<std::string, Json> settings;
  for (const Json& setting : report.at("settings")) settings[setting.at("name")] = setting;

  std::vector<std::string> names;
  add_names(names, of_scene);
  add_names(names, of_setting);
  add_names(names, of_result);
  names.emplace_back("chosen");
  std::string text = csv_row(names);
  for (const Json& scene : report.at("scenes")) {
    const std::string chosen = scene.value("chosen", "");
    for (const Json& result : scene.at("results")) {
      const std::string name = result.at("setting");
      const auto known = settings.find(name);
      std::vector<std::string> row;
      add(row, scene, of_scene);
      add(row, known != settings.end() ? known->second : Json{{"name", name}}, of_setting);
      add(row, result, of_result);
      row.emplace_back(name == chosen ? "true" : "false");
      text += csv_row(row);
    }
  }
  return text;
}

}  // namespace trace
