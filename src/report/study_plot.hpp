// The points of a study's picture, and where they are in it.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/log_scale.hpp"

namespace trace {

// Pixels.
struct PlotLayout {
  static constexpr double width = 970, top = 66, left = 76, right = 940, bottom = 560, radius = 5.5, row = 20;
};

// A setting over all scenes; time and error are relative to the first setting.
struct PlotPoint {
  std::string setting;
  std::size_t axis = 0;  // in the order of the report
  double time = 1, error = 1;
  bool none = false;  // no error: `error` is where it is drawn, half of the least there is
  bool front = false;
};

struct StudyPlot {
  std::vector<std::string> axes;  // their titles
  std::vector<PlotPoint> points;
  LogScale x, y;

  double x_of(const PlotPoint& point) const { return x(point.time); }
  double y_of(const PlotPoint& point) const { return y(point.error); }
  std::vector<PlotPoint> front() const;  // in the order of time
};

StudyPlot study_plot(const nlohmann::ordered_json& report);

// A name beside its point; `y` is the line that its letters stand on.
struct PlotName {
  double x, y;
  std::string text;
};

// Those of the front for which there is room beside all points, the front and each other.
std::vector<PlotName> place_names(const StudyPlot& plot);

}  // namespace trace
