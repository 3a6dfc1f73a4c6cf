// How often each pair of levels (reference, test) occurs at one place of two pictures, all channels together.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "comparison/diagnosis_pair.hpp"

namespace trace {

struct MovedLevel {
  int reference = 0;
  double mean = 0;  // of the test picture there
  std::size_t samples = 0;
};

class JointHistogram {
 public:
  explicit JointHistogram(const PicturePair& pair);

  // The levels of the reference below 255 that moved by more than two levels in the mean, and of which most
  // samples did not end as black or white. Rounding, and noise that is cut to bytes, move by up to one.
  std::vector<MovedLevel> moved_levels() const;

  // The share of samples that are not what the curve makes of the reference, of those that should or did
  // move: all but the ones that are as they were and that the curve leaves there. `curve` maps true values, 1
  // being full scale, and does not fall; values above one become 255.
  template <class Curve>
  double disobedient(const Curve& curve) const;

 private:
  // Samples of reference level v with a test level below t.
  std::size_t below(int v, int t) const {
    return cumulative_[static_cast<std::size_t>(v) * 257 + static_cast<std::size_t>(t)];
  }
  // Of level v, with a test level from `first` to `last`, cut to 0 and 255.
  std::size_t between(int v, int first, int last) const {
    first = std::max(first, 0);
    last = std::min(last, 255);
    return first > last ? 0 : below(v, last + 1) - below(v, first);
  }

  std::vector<std::size_t> cumulative_;
};

template <class Curve>
double JointHistogram::disobedient(const Curve& curve) const {
  constexpr double levels = 255;
  const auto level = [&](double value) {  // of the test picture, before it is rounded or cut
    return std::max(0.0, std::min(levels * value, levels));
  };
  std::size_t disobedient = 0, counted = 0;
  for (int v = 0; v < 256; ++v) {
    const std::size_t all = below(v, 256);
    if (all == 0) continue;
    // The interval of true values that v stands for, through the curve, one level wider at either end.
    const int first = static_cast<int>(std::ceil(level(curve((v - 0.5) / levels)) - 1));
    const int last = v == 255 ? 255 : static_cast<int>(level(curve((v + 1) / levels)) + 1);
    const std::size_t obedient = between(v, first, last);
    const bool may_stay = first <= v && v <= last;
    counted += may_stay ? all - between(v, v - 1, v + 1) : all;
    disobedient += all - obedient;
  }
  return counted == 0 ? 1 : static_cast<double>(disobedient) / static_cast<double>(counted);
}

}  // namespace trace
