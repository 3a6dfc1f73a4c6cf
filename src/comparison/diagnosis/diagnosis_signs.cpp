#include "comparison/diagnosis/diagnosis_signs.hpp"

#include <array>

namespace trace {
namespace {

// A level is a large part of a colour darker than this.
constexpr int dimmest_color = 20;
constexpr int black = 4;
// Cosine of the angle between two colours of one direction. An ambient light of another tint than the others
// turns a surface by up to some 12 degrees between shadow and light; surfaces of different hue are further
// apart.
constexpr double least_cosine = 0.975;
using Color = std::array<std::int64_t, 3>;

std::int64_t brightest(const Color& color) {
  return std::max({color[0], color[1], color[2]});
}

bool same_direction(const Color& a, const Color& b) {
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto ac = static_cast<double>(a[c]), bc = static_cast<double>(b[c]);
    ab += ac * bc;
    aa += ac * ac;
    bb += bc * bc;
  }
  return ab * ab >= least_cosine * least_cosine * aa * bb;  // neither has a negative part
}

std::size_t of_direction(const PicturePair& pair, const Color& direction) {
  std::size_t count = 0;
  for (const std::size_t i : pair.differing) {
    const std::uint8_t* reference = pair.of_reference(i);
    const std::uint8_t* test = pair.of_test(i);
    count += same_direction({std::abs(test[0] - reference[0]), std::abs(test[1] - reference[1]),
                             std::abs(test[2] - reference[2])},
                            direction);
  }
  return count;
}

}  // namespace

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

DifferenceSigns difference_signs(const PicturePair& pair) {
  std::size_t brighter = 0, darker = 0, same = 0, same_difference = 0, black_in_reference = 0,
              black_in_test = 0;
  Color mean{0, 0, 0};  // times the number of pixels
  DifferenceSigns signs;
  for (const std::size_t i : pair.differing) {
    Color reference, test, magnitude;
    bool up = false, down = false;
    for (std::size_t c = 0; c < 3; ++c) {
      reference[c] = pair.of_reference(i)[c];
      test[c] = pair.of_test(i)[c];
      const int d = test[c] - reference[c];
      magnitude[c] = std::abs(d);
      up = up || d > 1;
      down = down || d < -1;
      mean[c] += magnitude[c];
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
  }
  const auto count = static_cast<double>(pair.differing.size());
  signs.brighter = static_cast<double>(brighter) / count;
  signs.darker = static_cast<double>(darker) / count;
  signs.black_in_reference = static_cast<double>(black_in_reference) / count;
  signs.black_in_test = static_cast<double>(black_in_test) / count;
  signs.difference_of_same_color = static_cast<double>(same_difference) / count;
  if (signs.colored > 0) signs.same_color = static_cast<double>(same) / static_cast<double>(signs.colored);
  signs.difference_of_one_color = static_cast<double>(of_direction(pair, mean)) / count;
  return signs;
}

}  // namespace trace
