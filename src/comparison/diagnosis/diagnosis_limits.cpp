#include "comparison/diagnosis/diagnosis_limits.hpp"

#include <fmt/format.h>

#include <cstring>

namespace trace {
namespace {

// Of the samples that differ, what may be elsewhere than at the limit: mirrors mix what was limited before.
constexpr double most_elsewhere = 0.01;
// Samples at the limit beside one that is nearly there, by the trend just above the limit: after wrapping,
// dark.
constexpr int nearly = 240, dark = 48;
constexpr std::size_t least_beside = 16;
constexpr double least_dark = 0.8;

}  // namespace

std::optional<Finding> find_blank(const PicturePair& pair) {
  const auto one_color = [](const Image& image) {
    return std::memcmp(&image.rgb[0], &image.rgb[3], image.rgb.size() - 3) == 0;
  };
  if (!one_color(pair.test) || one_color(pair.reference)) return std::nullopt;
  const std::uint8_t* color = pair.of_test(0);
  const std::string text =
      std::max({color[0], color[1], color[2]}) == 0
          ? "black everywhere"
          : fmt::format("one colour everywhere: red {}, green {}, blue {}", color[0], color[1], color[2]);
  return Finding{{Diagnosis::Kind::blank, text}, 0};
}

std::optional<Finding> find_wrapped(const PicturePair& pair) {
  std::size_t differing = 0, elsewhere = 0, beside = 0, beside_dark = 0;
  for (const std::size_t i : pair.differing) {
    const std::uint8_t* reference = pair.of_reference(i);
    const std::uint8_t* test = pair.of_test(i);
    const bool at_left = i % static_cast<std::size_t>(pair.width) == 0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (std::abs(test[c] - reference[c]) <= 1) continue;
      ++differing;
      elsewhere += reference[c] != 255;
      if (at_left || reference[c] != 255) continue;
      const int left = pair.of_reference(i - 1)[c];
      if (left < nearly || left == 255) continue;
      ++beside;
      beside_dark += test[c] <= dark;
    }
  }
  const double left = static_cast<double>(elsewhere) / static_cast<double>(differing);
  if (left > most_elsewhere || beside < least_beside) return std::nullopt;
  if (static_cast<double>(beside_dark) < least_dark * static_cast<double>(beside)) return std::nullopt;
  return Finding{
      {Diagnosis::Kind::wrapped, "colours over the limit wrap around instead of being limited to 255"}, left};
}

}  // namespace trace
