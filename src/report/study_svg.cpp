#include "report/study_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "report/html_text.hpp"
#include "report/plain_text.hpp"
#include "report/study_plot.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;

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
    {"M-1-.6-.6-1 0-.4 .6-1 1-.6 .4 0 1 .6 .6 1 0 .4-.6 1-1 .6-.4 0Z", "#b0264f", "#ff8fae"},
    {"M0-1.2 1.14-.37 .71 .97-.71 .97-1.14-.37Z", "#9a6700", "#e3b341"},
};
constexpr std::size_t kind_count = std::size(kinds);

std::string safe(std::string_view text) {
  return html::escape(xml_text(text));
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
      kind, filled ? "" : " open", x, y, PlotLayout::radius, kinds[kind].shape, inside);
}

std::string grid(const StudyPlot& plot) {
  std::string text;
  for (const double tick : plot.x.ticks()) {
    const double x = plot.x(tick);
    text += fmt::format(
        "  <line class=\"line\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>\n"
        "  <text class=\"faint\" x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g} x</text>\n",
        x, PlotLayout::top, PlotLayout::bottom, PlotLayout::bottom + 18, tick);
  }
  for (const double tick : plot.y.ticks()) {
    const double y = plot.y(tick);
    text += fmt::format(
        "  <line class=\"line\" x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>\n"
        "  <text class=\"faint\" x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g} x</text>\n",
        y, PlotLayout::left, PlotLayout::right, PlotLayout::left - 8, y + 4, tick);
  }
  return text + fmt::format(
                    "  <text class=\"faint\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">Time</text>\n"
                    "  <text class=\"faint\" transform=\"translate(18 {}) rotate(-90)\" "
                    "text-anchor=\"middle\">Error</text>\n",
                    (PlotLayout::left + PlotLayout::right) / 2, PlotLayout::bottom + 38,
                    (PlotLayout::top + PlotLayout::bottom) / 2);
}

std::string front_line(const StudyPlot& plot) {
  std::string places;
  for (const PlotPoint& point : plot.front())
    places += fmt::format("{}{:.1f},{:.1f}", places.empty() ? "" : " ", plot.x_of(point), plot.y_of(point));
  return fmt::format("  <polyline class=\"front\" points=\"{}\"/>\n", places);
}

std::string names(const StudyPlot& plot) {
  std::string text;
  for (const PlotName& name : place_names(plot))
    text += fmt::format("  <text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", name.x, name.y, safe(name.text));
  return text;
}

std::string marks(const StudyPlot& plot) {
  std::string text;
  for (const PlotPoint& point : plot.points) {
    const std::string error = point.none ? "no error" : fmt::format("{:.3g} x the error", point.error);
    const double x = plot.x_of(point), y = plot.y_of(point);
    if (point.none)
      text += fmt::format("  <path class=\"front\" d=\"M{:.1f} {:.1f}v13m-3-3l3 3 3-3\"/>\n", x, y);
    text += mark(x, y, point.axis, point.front,
                 fmt::format("{}: {:.3g} x the time, {}", safe(point.setting), point.time, error));
  }
  return text;
}

// The axes that have points, in rows below; `height` grows by them.
std::string legend(const StudyPlot& plot, double& height) {
  std::string text;
  double x = PlotLayout::left;
  for (std::size_t axis = 0; axis < plot.axes.size(); ++axis) {
    if (std::none_of(plot.points.begin(), plot.points.end(),
                     [&](const PlotPoint& point) { return point.axis == axis; }))
      continue;
    const std::string& title = plot.axes[axis];
    const double wide = 40 + 6.6 * double(title.size());
    if (x > PlotLayout::left && x + wide > PlotLayout::right) {
      x = PlotLayout::left;
      height += PlotLayout::row;
    }
    text += mark(x + PlotLayout::radius, height - 4, axis, true) +
            fmt::format("  <text x=\"{:.1f}\" y=\"{}\">{}</text>\n", x + 18, height, safe(title));
    x += wide;
  }
  height += PlotLayout::row;
  return text;
}

std::string member(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

std::string study_svg(const Json& report) {
  const StudyPlot plot = study_plot(report);
  double height = PlotLayout::bottom + 66;
  const std::string keys = legend(plot, height);
  const auto scenes = report.at("all").at("scenes").get<long long>();
  const std::string processor = report.contains("machine") ? member(report["machine"], "processor") : "";
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
             "role=\"img\">\n  <title>Time against error of {2} settings over {3} scenes.</title>\n",
             PlotLayout::width, height, plot.points.size(), scenes) +
         style() +
         fmt::format("  <rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", PlotLayout::width, height) +
         fmt::format(
             "  <text class=\"head\" x=\"16\" y=\"26\">Time against error: {}</text>\n"
             "  <text class=\"faint\" x=\"16\" y=\"44\">{}geometric means over {} scenes, relative to the "
             "setting "
             "1; filled and joined: no other setting is better in both</text>\n",
             safe(member(report, "title")), processor.empty() ? "" : safe(processor) + ", ", scenes) +
         grid(plot) + front_line(plot) + marks(plot) + names(plot) + keys + "</svg>\n";
}

}  // namespace trace
