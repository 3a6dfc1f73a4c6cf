#include "tests/report/sample_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace trace::test {
namespace {

using Json = nlohmann::ordered_json;

// Each pixel's largest difference over its channels, in levels.
std::vector<int> differences(const Image& a, const Image& b) {
  std::vector<int> most(a.rgb.size() / 3);
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    most[i / 3] = std::max(most[i / 3], std::abs(int(a.rgb[i]) - int(b.rgb[i])));
  return most;
}

Json figures(const Image& solution, const Image& picture, std::size_t first, std::size_t step) {
  double sum = 0, squares = 0, signed_sum = 0, largest = 0, number = 0;
  for (std::size_t i = first; i < solution.rgb.size(); i += step, ++number) {
    const double difference = double(picture.rgb[i]) - double(solution.rgb[i]);
    sum += std::abs(difference);
    signed_sum += difference;
    squares += difference * difference;
    largest = std::max(largest, std::abs(difference));
  }
  const double rmse = std::sqrt(squares / number);
  return {{"mean_absolute", sum / number},
          {"root_mean_square", rmse},
          {"peak_signal_to_noise", rmse > 0 ? Json(20 * std::log10(255 / rmse)) : Json()},
          {"mean_signed", signed_sum / number},
          {"largest", largest}};
}

Json worst(const std::vector<int>& most, int width, int largest, double rmse) {
  int x0 = width, y0 = 1 << 20, x1 = 0, y1 = 0, pixels = 0;
  for (int i = 0; i < int(most.size()); ++i) {
    if (most[std::size_t(i)] * 2 <= largest) continue;
    x0 = std::min(x0, i % width), x1 = std::max(x1, i % width + 1);
    y0 = std::min(y0, i / width), y1 = std::max(y1, i / width + 1);
    ++pixels;
  }
  return {{"x0", x0}, {"y0", y0}, {"x1", x1}, {"y1", y1}, {"pixels", pixels}, {"root_mean_square", rmse}};
}

}  // namespace

Json sample_comparison(const Image& solution, const Image& picture) {
  const Json tolerance = {{"rmse", 0.5}, {"max", nullptr},  {"pixels", 0.1},
                          {"over", 1},   {"ssim", nullptr}, {"flip", nullptr}};
  Json comparison = {
      {"verdict", "size-differs"}, {"reason", ""}, {"diagnosis", nullptr}, {"tolerance", tolerance}};
  if (solution.width != picture.width || solution.height != picture.height) {
    comparison["reason"] = "the sizes differ";
    comparison["measurements"] = nullptr;
    return comparison;
  }
  const std::vector<int> most = differences(solution, picture);
  const auto at = std::max_element(most.begin(), most.end());
  const int pixel = int(at - most.begin());
  const auto share = [&](int over) {
    return 100.0 * double(std::count_if(most.begin(), most.end(), [&](int m) { return m > over; })) /
           double(most.size());
  };
  Json measured = figures(solution, picture, 0, 1);
  const double rmse = measured["root_mean_square"];
  measured.update({{"width", solution.width}, {"height", solution.height}, {"channels", 3}});
  std::size_t channel = std::size_t(pixel) * 3;
  while (std::abs(picture.rgb[channel] - solution.rgb[channel]) < *at) ++channel;
  measured["largest"] = {
      {"x", pixel % solution.width},  {"y", pixel / solution.width},
      {"channel", channel % 3},       {"reference", solution.rgb[channel]},
      {"test", picture.rgb[channel]}, {"difference", picture.rgb[channel] - solution.rgb[channel]}};
  for (std::size_t i = 0; i < 3; ++i) measured["channel"].push_back(figures(solution, picture, i, 3));
  measured.update({{"percent_different", share(0)},
                   {"percent_over_one", share(1)},
                   {"threshold", 1},
                   {"percent_over_threshold", share(1)},
                   {"ssim", nullptr},
                   {"flip", nullptr},
                   {"worst", Json::array()}});
  if (*at > 1) measured["worst"].push_back(worst(most, solution.width, *at, rmse));

  const bool within = rmse <= 0.5 && share(1) <= 0.1;
  comparison["verdict"] = *at == 0 ? "identical" : within ? "within" : "beyond";
  if (!within) comparison["reason"] = "beyond the tolerance";
  comparison["measurements"] = measured;
  return comparison;
}

Image sample_heat(const Image& solution, const Image& picture) {
  Image heat{solution.width, solution.height, {}};
  for (const int difference : differences(solution, picture))
    for (const int gain : {4, 2, 1}) heat.rgb.push_back(std::uint8_t(std::min(255, difference * gain)));
  return heat;
}

}  // namespace trace::test
