// Pictures in several kinds of arithmetic, and how they differ.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "loading/scene_loader.hpp"
#include "precision/arithmetic.hpp"
#include "tests/support/scene_picture.hpp"

namespace trace::test {

inline const std::filesystem::path precision_scenes = std::filesystem::path(TRACE_SOURCE_DIR) / "scenes";

inline Scene scene_of_file(const std::filesystem::path& file, int width) {
  FileImages images;
  LoadedScene loaded = load_scene(file.string(), width, images);
  if (!loaded.scene) throw std::runtime_error(loaded.messages);
  return std::move(*loaded.scene);
}

inline RenderOptions of_width(int width, int depth = 5) {
  RenderOptions options;
  options.width = width;
  options.depth = depth;
  options.threads = 1;
  return options;
}

// In levels, of all channels of all pixels.
struct LevelErrors {
  double root_mean_square = 0;
  int over_a_level = 0;  // pixels with a channel that differs by more than a level
  int pixels = 0;
};

inline LevelErrors level_errors(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  LevelErrors result;
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    bool over = false;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double off = 255 * (a[i + channel] - b[i + channel]);
      squares += off * off;
      over = over || std::abs(off) > 1;
    }
    result.over_a_level += over;
    ++result.pixels;
  }
  result.root_mean_square = std::sqrt(squares / static_cast<double>(a.size()));
  return result;
}

inline LevelErrors level_errors(const ArithmeticPicture& a, const ArithmeticPicture& b) {
  return level_errors(a.colors, b.colors);
}

// What render() draws, whose bytes are truncated, against colours truncated likewise.
inline LevelErrors level_errors(const Image& image, const ArithmeticPicture& picture) {
  std::vector<double> drawn, truncated;
  for (const std::uint8_t byte : image.rgb) drawn.push_back(byte / 255.0);
  for (const double channel : picture.colors) truncated.push_back(to_byte(channel) / 255.0);
  // Levels are whole here: 1.5 parts one from two, whatever the rounding of the quotients.
  for (double& level : drawn) level *= 2.0 / 3;
  for (double& level : truncated) level *= 2.0 / 3;
  LevelErrors result = level_errors(drawn, truncated);
  result.root_mean_square *= 1.5;
  return result;
}

}  // namespace trace::test
