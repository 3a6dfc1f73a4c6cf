#include "report/study_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "report/html_text.hpp"
#include "report/log_scale.hpp"
#include "report/plain_text.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;

// Pixels.
constexpr double width = 970, top = 66, left = 76, right = 940, bottom = 560, radius = 5.5, row = 20;

struct Kind {
  std::string_view shape;        // around the origin, about 1 in radius
  std::string_view light, dark;  // colours
};

// In the order of the report's axes; as in src/report/assets/study/shapes.js and study.css.
constexpr Kind kinds[] = {
    {"M1 0A1 1 0 1 1-1 0A1 1 0 1 1 1 0Z", "#1f5fbf", "#82b1ff"},
    {"M-.87-.87H.87V.87H-.87Z", "#b35900", "#ffb066"},
    {"M0-1.15 1.05 .8H-1.05Z", "#0b7a6b", "#5fd6c2"},
    {"M0-1.2 1.2 0 0 1.2-1.2 0Z", "#9b2fae", "#e39af2"},
    {"M0 1.15 1.05-.8H-1.05Z", "#5c7a00", "#b9d65a"},
    {"M-.4-1.1H.4V-.4H1.1V.4H.4V1.1H-.4V.4H-1.1V-.4H-.4Z", "#8a5a44", "#dcae96"},
    {"M-.55-1H.55L1.1 0 .55 1H-.55L-1.1 0Z", "#4f5b6b", "#b3bfcc"},
    {"M0-1.25 .37-.38 1.25-.35 .55 .22 .78 1.1 0 .6-.78 1.1-.55 .22-1.25-.35-.37-.38Z", "#6a4fd0", "#b7a5ff"},
};
constexpr std::size_t kind_count = std::size(kinds);

struct Point {
  std::string setting;
  std::size_t axis = 0;
  double time = 1, error = 1;
  bool none = false;  // no error: `error` is where it is drawn
  bool front = false;
};

struct Plot {
  std::vector<Json> axes;
  std::vector<Point> points;
  LogScale x{{}, left, right}, y{{}, bottom, top};
};

std::string safe(std::string_view text) {
  return html::escape(xml_text(text));
}

std::size_t axis_index(const std::vector<Json>& axes, const std::string& name) {
  const auto found =
      std::find_if(axes.begin(), axes.end(), [&](const Json& axis) { return axis.at("name") == name; });
  return found == axes.end() ? 0 : std::size_t(found - axes.begin());
}

std::vector<Point> points_of(const Json& report, const std::vector<Json>& axes) {
  std::map<std::string, std::size_t> axis_of;
  for (const Json& setting : report.at("settings"))
    axis_of[setting.at("name")] = axis_index(axes, setting.at("axis"));
  std::vector<Point> points;
  double least = 0;
  for (const Json& total : report.at("all").at("results")) {
    const std::string name = total.at("setting");
    const double error = total.at("error"), time = total.at("time");
    if (!(time > 0)) continue;
    if (error > 0) least = least > 0 ? std::min(least, error) : error;
    points.push_back({name, axis_of[name], time, error, !(error > 0), total.at("front")});
  }
  for (Point& point : points)
    if (point.none) point.error = least > 0 ? least / 2 : 1;
  return points;
}

Plot plot_of(const Json& report) {
  Plot plot;
  plot.axes.assign(report.at("axes").begin(), report.at("axes").end());
  plot.points = points_of(report, plot.axes);
  std::vector<double> times, errors;
  for (const Point& point : plot.points) {
    times.push_back(point.time);
    errors.push_back(point.error);
  }
  plot.x = LogScale(times, left, right);
  plot.y = LogScale(errors, bottom, top);
  return plot;
}

std::string style() {
  std::string light, dark;
  for (std::size_t i = 0; i < kind_count; ++i) {
    light += fmt::format("  .a{0} {{ fill: {1}; stroke: {1} }}\n", i, kinds[i].light);
    dark += fmt::format("    .a{0} {{ fill: {1}; stroke: {1} }}\n", i, kinds[i].dark);
  }
  return "  <style>\n"
         "  text { font: 12px system-ui, sans-serif; fill: #1f2328 }\n"
         "  .head { font-size: 15px; font-weight: 600 }\n"
         "  .faint { fill: #59636e }\n"
         "  .line { stroke: #d1d9e0 } .front { stroke: #59636e; stroke-width: 1.4; fill: none }\n"
         "  .paper { fill: #ffffff; stroke: none } .mark { stroke-width: 0.3 }\n" +
         light +
         "  .mark.open { fill: #ffffff }\n"
         "  @media (prefers-color-scheme: dark) {\n"
         "    text { fill: #f0f6fc } .faint { fill: #9198a1 } .line { stroke: #3d444d } .front { stroke: "
         "#9198a1 }\n"
         "    .paper { fill: #0d1117 }\n" +
         dark +
         "    .mark.open { fill: #0d1117 }\n"
         "  }\n"
         "  </style>\n";
}

std::string mark(double x, double y, std::size_t axis, bool filled, const std::string& title = "") {
  const std::size_t kind = axis % kind_count;
  const std::string inside = title.empty() ? "" : fmt::format("<title>{}</title>", title);
  return fmt::format(
      "  <path class=\"mark a{}{}\" transform=\"translate({:.1f} {:.1f}) scale({})\" d=\"{}\">{}</path>\n",
      kind, filled ? "" : " open", x, y, radius, kinds[kind].shape, inside);
}

std::string grid(const Plot& plot) {
  std::string text;
  for (const double tick : plot.x.ticks()) {
    const double x = plot.x(tick);
    text += fmt::format(
        "  <line class=\"line\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>\n"
        "  <text class=\"faint\" x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g} x</text>\n",
        x, top, bottom, bottom + 18, tick);
  }
  for (const double tick : plot.y.ticks()) {
    const double y = plot.y(tick);
    text += fmt::format(
        "  <line class=\"line\" x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>\n"
        "  <text class=\"faint\" x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g} x</text>\n",
        y, left, right, left - 8, y + 4, tick);
  }
  return text + fmt::format(
                    "  <text class=\"faint\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">Time</text>\n"
                    "  <text class=\"faint\" transform=\"translate(18 {}) rotate(-90)\" "
                    "text-anchor=\"middle\">Error</text>\n",
                    (left + right) / 2, bottom + 38, (top + bottom) / 2);
}

std::string front_line(const Plot& plot) {
  std::vector<Point> front;
  std::copy_if(plot.points.begin(), plot.points.end(), std::back_inserter(front),
               [](const Point& point) { return point.front; });
  std::sort(front.begin(), front.end(), [](const Point& a, const Point& b) { return a.time < b.time; });
  std::string places;
  for (const Point& point : front)
    places += fmt::format("{:.1f},{:.1f} ", plot.x(point.time), plot.y(point.error));
  if (!places.empty()) places.pop_back();
  return fmt::format("  <polyline class=\"front\" points=\"{}\"/>\n", places);
}

struct Box {
  double x0, y0, x1, y1;
  bool meets(const Box& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

// Names beside the points of the front, as far as there is room. A letter is taken to be 6.6 pixels wide.
std::string names(const Plot& plot) {
  std::vector<Box> taken;
  for (const Point& point : plot.points) {
    const double x = plot.x(point.time), y = plot.y(point.error);
    taken.push_back({x - radius, y - radius, x + radius, y + radius});
  }
  std::string text;
  for (const Point& point : plot.points) {
    if (!point.front) continue;
    const double x = plot.x(point.time), y = plot.y(point.error), wide = 6.6 * double(point.setting.size()),
                 tall = 12;
    const double starts[][2] = {{x + 9, y - 6},        {x - 9 - wide, y - 6},  {x + 5, y - 20},
                                {x - 5 - wide, y + 7}, {x - wide / 2, y - 21}, {x - wide / 2, y + 9}};
    for (const auto& [x0, y0] : starts) {
      const Box box{x0, y0, x0 + wide, y0 + tall};
      const bool inside = box.x0 >= left && box.x1 <= right && box.y0 >= top && box.y1 <= bottom;
      if (!inside ||
          std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); }))
        continue;
      taken.push_back(box);
      text += fmt::format("  <text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x0, y0 + 10, safe(point.setting));
      break;
    }
  }
  return text;
}

std::string marks(const Plot& plot) {
  std::string text;
  for (const Point& point : plot.points) {
    const std::string error = point.none ? "no error" : fmt::format("{:.3g} x the error", point.error);
    const double x = plot.x(point.time), y = plot.y(point.error);
    if (point.none)
      text += fmt::format("  <path class=\"front\" d=\"M{:.1f} {:.1f}v13m-3-3l3 3 3-3\"/>\n", x, y);
    text += mark(x, y, point.axis, point.front,
                 fmt::format("{}: {:.3g} x the time, {}", safe(point.setting), point.time, error));
  }
  return text;
}

// The axes that have points, in rows below; `height` grows by them.
std::string legend(const Plot& plot, double& height) {
  std::string text;
  double x = left;
  for (std::size_t axis = 0; axis < plot.axes.size(); ++axis) {
    if (std::none_of(plot.points.begin(), plot.points.end(),
                     [&](const Point& point) { return point.axis == axis; }))
      continue;
    const std::string title = plot.axes[axis].at("title");
    const double wide = 40 + 6.6 * double(title.size());
    if (x > left && x + wide > right) {
      x = left;
      height += row;
    }
    text += mark(x + radius, height - 4, axis, true) +
            fmt::format("  <text x=\"{:.1f}\" y=\"{}\">{}</text>\n", x + 18, height, safe(title));
    x += wide;
  }
  height += row;
  return text;
}

std::string member(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

std::string study_svg(const Json& report) {
  const Plot plot = plot_of(report);
  double height = bottom + 66;
  const std::string keys = legend(plot, height);
  const auto scenes = report.at("all").at("scenes").get<long long>();
  const std::string processor = report.contains("machine") ? member(report["machine"], "processor") : "";
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
             "role=\"img\">\n  <title>Time against error of {2} settings over {3} scenes.</title>\n",
             width, height, plot.points.size(), scenes) +
         style() + fmt::format("  <rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", width, height) +
         fmt::format(
             "  <text class=\"head\" x=\"16\" y=\"26\">Time against error: {}</text>\n"
             "  <text class=\"faint\" x=\"16\" y=\"44\">{}geometric means over {} scenes, relative to the "
             "setting "
             "1; filled and joined: no other setting is better in both</text>\n",
             safe(member(report, "title")), processor.empty() ? "" : safe(processor) + ", ", scenes) +
         grid(plot) + front_line(plot) + marks(plot) + names(plot) + keys + "</svg>\n";
}

}  // namespace trace
