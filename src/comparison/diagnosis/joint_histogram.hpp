// How often each pair of levels (reference, test) occurs at one place of two pictures, all channels together.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "comparison/diagnosis/diagnosis_pair.hpp"

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

  // The squared error that the curve leaves, as a share of what there is.
  template <class Curve>
  double energy_left(const Curve& curve) const;

 private:
  // Test levels, both included.
  struct Interval {
    int first, last;
  };
  // The interval of true values that level v stands for, through the curve, one level wider at either end.
  template <class Curve>
  static Interval image(int v, const Curve& curve) {
    const auto level = [](double value) { return std::max(0.0, std::min(255 * value, 255.0)); };
    return {static_cast<int>(std::ceil(level(curve((v - 0.5) / 255)) - 1)),
            v == 255 ? 255 : static_cast<int>(level(curve((v + 1) / 255.0)) + 1)};
  }

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
  std::size_t disobedient = 0, counted = 0;
  for (int v = 0; v < 256; ++v) {
    const std::size_t all = below(v, 256);
    if (all == 0) continue;
    const auto [first, last] = image(v, curve);
    const bool may_stay = first <= v && v <= last;
    counted += may_stay ? all - between(v, v - 1, v + 1) : all;
    disobedient += all - between(v, first, last);
  }
  return counted == 0 ? 1 : static_cast<double>(disobedient) / static_cast<double>(counted);
}

template <class Curve>
double JointHistogram::energy_left(const Curve& curve) const {
  double before = 0, after = 0;
  for (int v = 0; v < 256; ++v) {
    if (below(v, 256) == 0) continue;
    const auto [first, last] = image(v, curve);
    for (int t = 0; t < 256; ++t) {
      const auto samples = static_cast<double>(between(v, t, t));
      const double left = t < first ? first - t : (t > last ? t - last : 0);
      before += samples * (t - v) * (t - v);
      after += samples * left * left;
    }
  }
  return before > 0 ? after / before : 1;
}

}  // namespace trace
