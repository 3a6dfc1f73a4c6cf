#include "report/comparison_csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trace {
namespace {

constexpr std::size_t max_channels = 4;
constexpr std::size_t max_regions = 3;

// Names and fields are made by one walk over the figures, so that they cannot get out of step.
class Row {
 public:
  std::vector<std::string> names, fields;

  void text(std::string column, std::string_view value) {
    names.push_back(std::move(column));
    fields.emplace_back(value);
  }
  template <class Number>
  void figure(bool known, std::string column, Number value) {
    text(std::move(column), known ? written(value) : std::string());
  }

 private:
  static std::string written(std::optional<double> value) { return value ? written(*value) : std::string(); }
  static std::string written(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }
  static std::string written(int value) { return fmt::format("{}", value); }
  static std::string written(std::size_t value) { return fmt::format("{}", value); }
};

void add_error(Row& row, bool known, const std::string& prefix, const ErrorFigures& error) {
  row.figure(known, prefix + "mean_absolute", error.mean_absolute);
  row.figure(known, prefix + "root_mean_square", error.root_mean_square);
  row.figure(known, prefix + "peak_signal_to_noise", error.peak_signal_to_noise);
  row.figure(known, prefix + "mean_signed", error.mean_signed);
  row.figure(known, prefix + "largest", error.largest);
}

void add_picture(Row& row, bool known, const Measurements& m) {
  row.figure(known, "width", m.width);
  row.figure(known, "height", m.height);
  row.figure(known, "channels", m.channels);
  add_error(row, known, "", m.error);
  row.figure(known, "largest_x", m.largest.pixel.x);
  row.figure(known, "largest_y", m.largest.pixel.y);
  row.figure(known, "largest_channel", m.largest.channel);
  row.figure(known, "largest_reference", m.largest.reference);
  row.figure(known, "largest_test", m.largest.test);
  row.figure(known, "percent_different", m.percent_different);
  row.figure(known, "percent_over_one", m.percent_over_one);
  row.figure(known, "threshold", m.threshold);
  row.figure(known, "percent_over_threshold", m.percent_over_threshold);
  row.figure(known, "p50", m.percentiles.p50);
  row.figure(known, "p90", m.percentiles.p90);
  row.figure(known, "p99", m.percentiles.p99);
  row.figure(known, "p99.9", m.percentiles.p999);
  row.figure(known, "ssim", m.ssim);
  row.figure(known, "flip", m.flip);
}

void add_parts(Row& row, bool known, const Measurements& m) {
  row.figure(known, "foreground_pixels", m.foreground.pixels);
  add_error(row, known, "foreground_", m.foreground.error);
  row.figure(known, "foreground_percent_over_one", m.foreground.percent_over_one);
  row.figure(known, "edge_tolerant_root_mean_square", m.edge_tolerant.root_mean_square);
  row.figure(known, "edge_tolerant_largest", m.edge_tolerant.largest);
  row.figure(known, "edge_tolerant_percent_over_one", m.edge_tolerant.percent_over_one);
  row.figure(known, "not_finite_reference", m.not_finite.reference);
  row.figure(known, "not_finite_test", m.not_finite.test);
  const bool any = known && m.not_finite.reference + m.not_finite.test > 0;
  row.figure(any, "not_finite_first_x", m.not_finite.first.x);
  row.figure(any, "not_finite_first_y", m.not_finite.first.y);
  for (std::size_t i = 0; i < max_channels; ++i) {
    const bool there = known && i < m.channel.size();
    add_error(row, there, fmt::format("channel{}_", i), there ? m.channel[i] : ErrorFigures{});
  }
  for (std::size_t i = 0; i < max_regions; ++i) {
    const bool there = known && i < m.worst.size();
    const Region region = there ? m.worst[i] : Region{};
    const std::string prefix = fmt::format("worst{}_", i);
    row.figure(there, prefix + "x0", region.x0);
    row.figure(there, prefix + "y0", region.y0);
    row.figure(there, prefix + "x1", region.x1);
    row.figure(there, prefix + "y1", region.y1);
    row.figure(there, prefix + "pixels", region.pixels);
    row.figure(there, prefix + "root_mean_square", region.root_mean_square);
  }
}

Row row_of(const Judgement& judgement) {
  Row row;
  row.text("verdict", name(judgement.verdict));
  row.text("reason", judgement.reason);
  row.text("diagnosis", judgement.diagnosis ? judgement.diagnosis->text : "");
  const bool known = judgement.measurements.has_value();
  const Measurements m = judgement.measurements.value_or(Measurements{});
  add_picture(row, known, m);
  add_parts(row, known, m);
  return row;
}

}  // namespace

std::vector<std::string> comparison_columns() {
  return row_of(Judgement{}).names;
}

std::vector<std::string> comparison_fields(const Judgement& judgement) {
  return row_of(judgement).fields;
}

}  // namespace trace
