#include "report/study_plot.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

namespace trace {
namespace {

using Json = nlohmann::ordered_json;

// Of each setting, by its name.
std::map<std::string, std::size_t> axes_of_settings(const Json& report) {
  std::map<std::string, std::size_t> index, found;
  for (const Json& axis : report.at("axes")) index.try_emplace(axis.at("name"), index.size());
  for (const Json& setting : report.at("settings")) found[setting.at("name")] = index[setting.at("axis")];
  return found;
}

// JSON has null for what is not finite; such points are not drawn.
std::vector<PlotPoint> points_of(const Json& report) {
  const auto axes = axes_of_settings(report);
  std::vector<PlotPoint> points;
  double least = 0;
  for (const Json& total : report.at("all").at("results")) {
    if (!total.at("time").is_number() || !total.at("error").is_number()) continue;
    const double error = total.at("error"), time = total.at("time");
    const auto axis = axes.find(total.at("setting"));
    if (!(time > 0) || axis == axes.end()) continue;
    if (error > 0) least = least > 0 ? std::min(least, error) : error;
    points.push_back({axis->first, axis->second, time, error, !(error > 0), total.at("front")});
  }
  for (PlotPoint& point : points)
    if (point.none) point.error = least > 0 ? least / 2 : 1;
  return points;
}

}  // namespace

std::vector<PlotPoint> StudyPlot::front() const {
  std::vector<PlotPoint> found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found),
               [](const PlotPoint& point) { return point.front; });
  std::sort(found.begin(), found.end(),
            [](const PlotPoint& a, const PlotPoint& b) { return a.time < b.time; });
  return found;
}

StudyPlot study_plot(const Json& report) {
  std::vector<std::string> axes;
  for (const Json& axis : report.at("axes")) axes.push_back(axis.at("title"));
  const std::vector<PlotPoint> points = points_of(report);
  std::vector<double> times, errors;
  for (const PlotPoint& point : points) {
    times.push_back(point.time);
    errors.push_back(point.error);
  }
  return {axes, points, LogScale(times, PlotLayout::left, PlotLayout::right),
          LogScale(errors, PlotLayout::bottom, PlotLayout::top)};
}

}  // namespace trace
