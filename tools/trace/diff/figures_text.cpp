#include "tools/trace/diff/figures_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace trace {
namespace {

std::string size_line(const Measurements& m) {
  return fmt::format("{} x {} pixels, {}\n", m.width, m.height,
                     m.channels == 1 ? std::string("1 channel") : fmt::format("{} channels", m.channels));
}

std::string table_row(std::string_view title, const std::vector<std::string>& cells) {
  std::string line = fmt::format("{:<16}", title);
  for (const std::string& cell : cells) line += fmt::format("{:>10}", cell);
  return line + "\n";
}

// Figures over all channels and, where there are several, of each.
std::string table(const Measurements& m) {
  std::vector<const ErrorFigures*> columns = {&m.error};
  std::vector<std::string> titles = {"all"};
  if (m.channel.size() > 1) {
    for (std::size_t i = 0; i < m.channel.size(); ++i) {
      columns.push_back(&m.channel[i]);
      titles.push_back(channel_name(static_cast<int>(i), m.channels));
    }
  }
  std::string text = table_row("in levels", titles);
  const auto add = [&](std::string_view title, double ErrorFigures::*member) {
    std::vector<std::string> cells;
    for (const ErrorFigures* column : columns) cells.push_back(figure(column->*member));
    text += table_row(title, cells);
  };
  add("RMSE", &ErrorFigures::root_mean_square);
  add("mean absolute", &ErrorFigures::mean_absolute);
  add("mean signed", &ErrorFigures::mean_signed);
  add("largest", &ErrorFigures::largest);
  add("PSNR in dB", &ErrorFigures::peak_signal_to_noise);
  return text;
}

std::string line(std::string_view title, const std::string& text) {
  return fmt::format("{:<16}  {}\n", title, text);
}

std::string perceived(const Measurements& m) {
  std::string text;
  if (m.ssim) text += line("SSIM", figure(*m.ssim));
  if (m.flip) text += line("FLIP", figure(*m.flip));
  return text;
}

std::string pixels(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "pixel" : "pixels");
}

// Corners inclusive.
std::string corners(const Region& r) {
  const std::string first = fmt::format("({}, {})", r.x0, r.y0);
  if (r.x1 - r.x0 == 1 && r.y1 - r.y0 == 1) return first;
  return fmt::format("{} to ({}, {})", first, r.x1 - 1, r.y1 - 1);
}

std::string worst(const std::vector<Region>& regions) {
  std::string text;
  for (const Region& r : regions) {
    text += line(text.empty() ? "worst regions" : "",
                 fmt::format("{}: {}, RMSE {}", corners(r), pixels(r.pixels), figure(r.root_mean_square)));
  }
  return text;
}

}  // namespace

std::string figure(double value) {
  // 1e-20 would only be noise.
  if (std::abs(value) < 5e-5) return "0";
  return fmt::format("{:.4g}", value);
}

std::string channel_name(int channel, int channels) {
  if ((channels == 2 || channels == 4) && channel == channels - 1) return "alpha";
  if (channels <= 2) return "gray";
  if (channels <= 4) return std::vector{"red", "green", "blue"}[static_cast<std::size_t>(channel)];
  return fmt::format("channel {}", channel);
}

std::string figures_text(const Measurements& m) {
  std::string text = size_line(m);
  if (m.error.largest == 0) return text;
  text += table(m);
  const LargestDifference& l = m.largest;
  text += line("largest at",
               fmt::format("({}, {}), {}: {} instead of {}", l.pixel.x, l.pixel.y,
                           channel_name(l.channel, m.channels), figure(l.test), figure(l.reference)));
  text += line("pixels", fmt::format("{} % differ, {} % by more than 1 level", figure(m.percent_different),
                                     figure(m.percent_over_one)));
  if (m.threshold != 1) {
    text += line("", fmt::format("{} % by more than {} levels", figure(m.percent_over_threshold),
                                 figure(m.threshold)));
  }
  const Percentiles& p = m.percentiles;
  text += line("percentiles", fmt::format("50: {}  90: {}  99: {}  99.9: {}", figure(p.p50), figure(p.p90),
                                          figure(p.p99), figure(p.p999)));
  const Foreground& f = m.foreground;
  text += line("foreground", fmt::format("{}, RMSE {}, {} % by more than 1 level", pixels(f.pixels),
                                         figure(f.error.root_mean_square), figure(f.percent_over_one)));
  const EdgeTolerant& e = m.edge_tolerant;
  text += line("edge-tolerant",
               fmt::format("RMSE {}, largest {}, {} % by more than 1 level", figure(e.root_mean_square),
                           figure(e.largest), figure(e.percent_over_one)));
  return text + perceived(m) + worst(m.worst);
}

}  // namespace trace
