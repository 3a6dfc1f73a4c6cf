#include "comparison/diagnosis_signs.hpp"

#include <array>
#include <cmath>

namespace trace {
namespace {

// A level is a large part of a colour darker than this.
constexpr int dimmest_color = 20;
constexpr int black = 4;
// Cosine of the angle between two colours of one direction. An ambient light of another tint than the others turns
// a surface by up to some 12 degrees between shadow and light; surfaces of different hue are further apart.
constexpr double least_cosine = 0.975;
// The most frequent differences that are looked at: about as many as a scene has kinds of surfaces.
constexpr int modes = 8;
constexpr int mode_width = 7;  // of the sum of three channels, each rounded twice

using Color = std::array<int, 3>;

int brightest(const Color& color) {
  return std::max({color[0], color[1], color[2]});
}

bool same_direction(const Color& a, const Color& b) {
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    ab += a[c] * b[c];
    aa += a[c] * a[c];
    bb += b[c] * b[c];
  }
  return ab >= least_cosine * std::sqrt(aa * bb);
}

double lit_and_equal(const PicturePair& pair) {
  std::size_t lit = 0, equal = 0;
  for (std::size_t i = 0; i < pair.differs.size(); ++i) {
    const std::uint8_t* reference = pair.of_reference(i);
    const bool is_lit = pair.differs[i] || std::max({reference[0], reference[1], reference[2]}) > black;
    lit += is_lit;
    equal += is_lit && !pair.differs[i];
  }
  return lit == 0 ? 0 : static_cast<double>(equal) / static_cast<double>(lit);
}

double concentration(std::vector<std::size_t> counts, std::size_t total) {
  if (total == 0) return 0;
  std::size_t held = 0;
  for (int mode = 0; mode < modes; ++mode) {
    std::size_t window = 0, best = 0, best_end = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      window += counts[i];
      if (i >= mode_width) window -= counts[i - mode_width];
      if (window > best) {
        best = window;
        best_end = i;
      }
    }
    held += best;
    for (std::size_t k = 0; k < mode_width && k <= best_end; ++k) counts[best_end - k] = 0;
  }
  return static_cast<double>(held) / static_cast<double>(total);
}

}  // namespace

DifferenceSigns difference_signs(const PicturePair& pair) {
  std::size_t brighter = 0, darker = 0, same = 0, same_difference = 0, black_in_reference = 0,
              black_in_test = 0;
  std::vector<std::size_t> differences(2 * 765 + 1), references(766);
  DifferenceSigns signs;
  for (const std::size_t i : pair.differing) {
    Color reference, test, magnitude;
    bool up = false, down = false, limited = false;
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      reference[c] = pair.of_reference(i)[c];
      test[c] = pair.of_test(i)[c];
      const int d = test[c] - reference[c];
      magnitude[c] = std::abs(d);
      up = up || d > 1;
      down = down || d < -1;
      limited = limited || reference[c] == 255 || test[c] == 255;
      sum += d;
    }
    brighter += up;
    darker += down;
    black_in_reference += brightest(reference) <= black;
    black_in_test += brightest(test) <= black;
    const Color& dim = brightest(test) < brightest(reference) ? test : reference;
    const Color& lit = brightest(test) < brightest(reference) ? reference : test;
    if (brightest(dim) >= dimmest_color) {
      ++signs.colored;
      same += same_direction(reference, test);
    }
    same_difference += same_direction(magnitude, lit);
    if (!limited) {
      ++signs.within_limits;
      ++differences[static_cast<std::size_t>(sum + 765)];
      ++references[static_cast<std::size_t>(reference[0] + reference[1] + reference[2])];
    }
  }
  const auto count = static_cast<double>(pair.differing.size());
  signs.brighter = static_cast<double>(brighter) / count;
  signs.darker = static_cast<double>(darker) / count;
  signs.black_in_reference = static_cast<double>(black_in_reference) / count;
  signs.black_in_test = static_cast<double>(black_in_test) / count;
  signs.lit_and_equal = lit_and_equal(pair);
  signs.difference_of_same_color = static_cast<double>(same_difference) / count;
  if (signs.colored > 0) signs.same_color = static_cast<double>(same) / static_cast<double>(signs.colored);
  signs.concentration = concentration(std::move(differences), signs.within_limits);
  signs.concentration_of_reference = concentration(std::move(references), signs.within_limits);
  return signs;
}

}  // namespace trace
