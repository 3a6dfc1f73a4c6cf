#include "tools/trace/diff/tolerance_update.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "loading/tolerance_file.hpp"
#include "report/plain_text.hpp"

namespace trace {
namespace {

using json = nlohmann::ordered_json;

// The least number of `decimals` decimals that is not below `value`; correctly rounded, since a product with
// a power of ten is not.
double up(double value, int decimals) {
  const double unit = std::pow(10, std::abs(decimals));
  const auto decimal = [&](double steps) { return decimals >= 0 ? steps / unit : steps * unit; };
  double steps = std::floor(decimals >= 0 ? value * unit : value / unit);
  while (decimal(steps) < value) ++steps;
  return decimal(steps);
}

double up_two_digits(double value) {
  if (!(value > 0) || !std::isfinite(value)) return value;
  return up(value, 1 - static_cast<int>(std::floor(std::log10(value))));
}

json entry_of(const Tolerance& t, const std::string& reason) {
  json entry = json::object();
  const auto add = [&](const char* key, const std::optional<double>& limit) {
    if (limit) entry[key] = *limit;
  };
  add("rmse", t.rmse);
  add("max", t.max);
  add("pixels", t.pixels);
  if (t.pixels) entry["over"] = t.over;
  add("ssim", t.ssim);
  add("flip", t.flip);
  if (entry.empty()) entry["rmse"] = nullptr;
  entry["reason"] = valid_utf8(reason);
  return entry;
}

}  // namespace

Tolerance accepting(const Tolerance& tolerance, const Measurements& measured) {
  Tolerance result = tolerance;
  const auto widen = [](std::optional<double>& limit, double value) {
    if (limit && value > *limit) limit = up_two_digits(value);
  };
  widen(result.rmse, measured.error.root_mean_square);
  widen(result.max, measured.error.largest);
  widen(result.pixels, measured.percent_over_threshold);
  if (result.pixels) result.pixels = std::min(*result.pixels, 100.0);
  if (measured.flip) widen(result.flip, *measured.flip);
  if (result.flip) result.flip = std::min(*result.flip, 1.0);
  if (result.ssim && measured.ssim && *measured.ssim < *result.ssim) result.ssim = -up(-*measured.ssim, 4);
  return result;
}

std::string with_accepted(const std::string& text, const std::vector<AcceptedScene>& accepted,
                          const std::string& reason) {
  json file = text.empty() ? json::object() : json::parse(text);
  for (const AcceptedScene& one : accepted)
    file[valid_utf8(literal_pattern(one.scene))] = entry_of(one.tolerance, reason);
  std::string result = "{";
  for (const auto& [name, entry] : file.items()) {
    result += result.size() == 1 ? "\n" : ",\n";
    result += "  " + json(name).dump() + ": " + entry.dump();
  }
  return result + "\n}\n";
}

}  // namespace trace
