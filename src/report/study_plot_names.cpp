#include <algorithm>
#include <cmath>

#include "report/study_plot.hpp"

namespace trace {
namespace {

constexpr double letter_width = 6.6, letter_height = 14, baseline = 11;  // about, of the type that is used

struct Box {
  double x0, y0, x1, y1;
  bool meets(const Box& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
  bool inside() const {
    return x0 >= PlotLayout::left && x1 <= PlotLayout::right && y0 >= PlotLayout::top &&
           y1 <= PlotLayout::bottom;
  }
};

void add_points(const StudyPlot& plot, std::vector<Box>& taken) {
  constexpr double r = PlotLayout::radius;
  for (const PlotPoint& point : plot.points) {
    const double x = plot.x_of(point), y = plot.y_of(point);
    taken.push_back({x - r, y - r, x + r, y + r});
  }
}

// Small boxes along the front.
void add_front(const StudyPlot& plot, std::vector<Box>& taken) {
  const std::vector<PlotPoint> front = plot.front();
  for (std::size_t i = 1; i < front.size(); ++i) {
    const double x0 = plot.x_of(front[i - 1]), y0 = plot.y_of(front[i - 1]);
    const double dx = plot.x_of(front[i]) - x0, dy = plot.y_of(front[i]) - y0;
    const int pieces = int(std::hypot(dx, dy) / 6) + 1;
    for (int piece = 1; piece < pieces; ++piece) {
      const double x = x0 + dx * piece / pieces, y = y0 + dy * piece / pieces;
      taken.push_back({x - 1, y - 1, x + 1, y + 1});
    }
  }
}

}  // namespace

std::vector<PlotName> place_names(const StudyPlot& plot) {
  std::vector<Box> taken;
  add_points(plot, taken);
  add_front(plot, taken);
  std::vector<PlotName> names;
  for (const PlotPoint& point : plot.front()) {
    const double x = plot.x_of(point), y = plot.y_of(point);
    const double wide = letter_width * double(point.setting.size()), above = y - 6 - letter_height,
                 below = y + 6;
    const double beside = y - letter_height / 2;
    const double corners[][2] = {{x + 9, beside},           {x + 6, above},           {x - 9 - wide, beside},
                                 {x - 6 - wide, below},     {x + 6, below},           {x - 6 - wide, above},
                                 {x - wide / 2, above - 4}, {x - wide / 2, below + 4}};
    for (const auto& [left, top] : corners) {
      const Box box{left, top, left + wide, top + letter_height};
      if (!box.inside() ||
          std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); }))
        continue;
      taken.push_back(box);
      names.push_back({left, top + baseline, point.setting});
      break;
    }
  }
  return names;
}

}  // namespace trace
