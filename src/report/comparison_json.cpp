#include "report/comparison_json.hpp"

#include <cmath>

#include "report/plain_text.hpp"

namespace trace {
namespace {

using json = nlohmann::ordered_json;

json number(double value) {
  return std::isfinite(value) ? json(value) : json();
}

json number(const std::optional<double>& value) {
  return value ? number(*value) : json();
}

json place(const Pixel& pixel) {
  return {{"x", pixel.x}, {"y", pixel.y}};
}

json figures(const ErrorFigures& error) {
  return {{"mean_absolute", number(error.mean_absolute)},
          {"root_mean_square", number(error.root_mean_square)},
          {"peak_signal_to_noise", number(error.peak_signal_to_noise)},
          {"mean_signed", number(error.mean_signed)}};
}

json channel(const ErrorFigures& error) {
  json result = figures(error);
  result["largest"] = number(error.largest);
  return result;
}

json largest(const Measurements& m) {
  json result = place(m.largest.pixel);
  result["channel"] = m.largest.channel;
  result["reference"] = number(m.largest.reference);
  result["test"] = number(m.largest.test);
  result["difference"] = number(m.error.largest);
  return result;
}

json foreground(const Foreground& f) {
  json result = {{"pixels", f.pixels}};
  result.update(channel(f.error));
  result["percent_over_one"] = number(f.percent_over_one);
  return result;
}

json not_finite(const NotFinite& n) {
  return {{"reference", n.reference},
          {"test", n.test},
          {"first", n.reference + n.test > 0 ? place(n.first) : json()}};
}

json region(const Region& r) {
  return {{"x0", r.x0}, {"y0", r.y0},         {"x1", r.x1},
          {"y1", r.y1}, {"pixels", r.pixels}, {"root_mean_square", number(r.root_mean_square)}};
}

json measurements(const Measurements& m) {
  json result = {{"width", m.width}, {"height", m.height}, {"channels", m.channels}};
  result.update(figures(m.error));
  result["largest"] = largest(m);
  json& channels = result["channel"] = json::array();
  for (const ErrorFigures& error : m.channel) channels.push_back(channel(error));
  result["percent_different"] = number(m.percent_different);
  result["percent_over_one"] = number(m.percent_over_one);
  result["threshold"] = number(m.threshold);
  result["percent_over_threshold"] = number(m.percent_over_threshold);
  result["percentiles"] = {{"p50", number(m.percentiles.p50)},
                           {"p90", number(m.percentiles.p90)},
                           {"p99", number(m.percentiles.p99)},
                           {"p99.9", number(m.percentiles.p999)}};
  result["ssim"] = number(m.ssim);
  result["flip"] = number(m.flip);
  result["foreground"] = foreground(m.foreground);
  result["edge_tolerant"] = {{"root_mean_square", number(m.edge_tolerant.root_mean_square)},
                             {"largest", number(m.edge_tolerant.largest)},
                             {"percent_over_one", number(m.edge_tolerant.percent_over_one)}};
  result["not_finite"] = not_finite(m.not_finite);
  json& worst = result["worst"] = json::array();
  for (const Region& r : m.worst) worst.push_back(region(r));
  return result;
}

}  // namespace

json comparison_json(const Judgement& judgement) {
  const Tolerance& t = judgement.tolerance;
  json result = {{"verdict", name(judgement.verdict)}, {"reason", valid_utf8(judgement.reason)}};
  result["diagnosis"] = judgement.diagnosis ? json{{"kind", name(judgement.diagnosis->kind)},
                                                   {"text", valid_utf8(judgement.diagnosis->text)}}
                                            : json();
  result["tolerance"] = {{"rmse", number(t.rmse)}, {"max", number(t.max)},   {"pixels", number(t.pixels)},
                         {"over", number(t.over)}, {"ssim", number(t.ssim)}, {"flip", number(t.flip)}};
  result["measurements"] = judgement.measurements ? measurements(*judgement.measurements) : json();
  return result;
}

}  // namespace trace
