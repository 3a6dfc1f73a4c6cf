#include "comparison/diagnosis/diagnosis_tone.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparison/diagnosis/joint_histogram.hpp"

namespace trace {
namespace {

// Of the samples that moved, at most this share may disobey the curve. A true curve is obeyed by all but
// those that a renderer limited to one before it mixed them further (in mirrors).
constexpr double most_disobedient = 0.01;
// Of the squared error, what may be left: few pixels with another, larger error are a second cause.
constexpr double most_energy = 0.02;
// Distinct levels of the reference among the samples that moved: with fewer, any curve passes through them.
constexpr std::size_t fewest_levels = 8;
// The better kind of curve must leave this much less than the other.
constexpr double better_curve = 4;
constexpr double equal_curves = 0.001;

struct Fit {
  double parameter = 1;
  double unexplained = 1;
};

// The curve of the family with the least share of disobedient samples; among equals the middle of the
// plateau. Looks at equal ratios of the parameter, at `steps` of them either way from `guess`.
template <class Curve>
Fit fit(const JointHistogram& histogram, double guess, const Curve& curve) {
  constexpr int steps = 24;
  constexpr double ratio = 1.005;  // from one to the next: below what a level in 255 can tell apart
  // Plateaus end raggedly: a thousandth is no reason to move.
  constexpr double ragged = 0.001;
  Fit best;
  double first = guess, last = guess;
  for (int i = -steps; i <= steps; ++i) {
    const double parameter = guess * std::pow(ratio, i);
    const double left = histogram.disobedient([&](double v) { return curve(v, parameter); });
    if (left < best.unexplained - ragged) {
      best.unexplained = left;
      first = last = parameter;
    } else if (left <= best.unexplained + ragged) {
      last = parameter;
    }
  }
  best.parameter = std::sqrt(first * last);
  return best;
}

// The median, weighted by the number of samples, of the parameter that takes a level of the reference to the
// mean of its samples in the test picture.
template <class Parameter>
double guess(const std::vector<MovedLevel>& levels, const Parameter& parameter) {
  std::vector<std::pair<double, std::size_t>> found;
  std::size_t total = 0;
  for (const MovedLevel& level : levels) {
    // A program that rounds means v, one that truncates v + 1/2: the guess is between.
    found.emplace_back(parameter((level.reference + 0.25) / 255, (level.mean + 0.25) / 255), level.samples);
    total += level.samples;
  }
  std::sort(found.begin(), found.end());
  std::size_t passed = 0;
  for (const auto& [value, samples] : found)
    if ((passed += samples) * 2 >= total) return value;
  return 1;
}

double power(double v, double exponent) {
  return v <= 0 ? 0 : std::pow(v, exponent);
}

// IEC 61966-2-1.
double srgb(double v) {
  return v <= 0.0031308 ? 12.92 * std::max(v, 0.0) : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}
double from_srgb(double v) {
  return v <= 0.04045 ? std::max(v, 0.0) / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// A known curve where it is obeyed as well as the best exponent: all but as much as noise in few pixels
// makes.
Finding gamma_finding(const JointHistogram& histogram, const Fit& gamma) {
  constexpr double noise = 0.005;
  const auto finding = [](double left, const std::string& text) {
    return Finding{{Diagnosis::Kind::gamma, text}, left};
  };
  for (const double known : {2.2, 1.8, 2.0, 2.4}) {
    const double applied = histogram.disobedient([&](double v) { return power(v, 1 / known); });
    if (applied <= gamma.unexplained + noise)
      return finding(applied, fmt::format("gamma {} was applied", known));
    const double removed = histogram.disobedient([&](double v) { return power(v, known); });
    if (removed <= gamma.unexplained + noise)
      return finding(removed, fmt::format("gamma {} was removed", known));
  }
  const double applied = histogram.disobedient(srgb), removed = histogram.disobedient(from_srgb);
  if (applied <= gamma.unexplained + noise) return finding(applied, "the sRGB curve was applied");
  if (removed <= gamma.unexplained + noise) return finding(removed, "the sRGB curve was removed");
  if (gamma.parameter < 1)
    return finding(gamma.unexplained, fmt::format("gamma {:.2f} was applied", 1 / gamma.parameter));
  return finding(gamma.unexplained, fmt::format("gamma {:.2f} was removed", gamma.parameter));
}

}  // namespace

std::optional<Finding> find_tone(const PicturePair& pair) {
  const JointHistogram histogram(pair);
  const auto levels = histogram.moved_levels();
  if (levels.size() < fewest_levels) return std::nullopt;
  const Fit gamma =
      fit(histogram, guess(levels, [](double v, double t) { return std::log(t) / std::log(v); }), power);
  const Fit factor = fit(histogram, guess(levels, [](double v, double t) { return t / v; }),
                         [](double v, double f) { return v * f; });

  Finding best = gamma_finding(histogram, gamma);
  Finding other{
      {Diagnosis::Kind::brightness, fmt::format("brightness is scaled by {:.2f}", factor.parameter)},
      factor.unexplained};
  if (other.unexplained < best.unexplained) std::swap(best, other);
  if (best.unexplained > most_disobedient) return std::nullopt;
  const double left = best.diagnosis.kind == Diagnosis::Kind::gamma
                          ? histogram.energy_left([&](double v) { return power(v, gamma.parameter); })
                          : histogram.energy_left([&](double v) { return v * factor.parameter; });
  if (left > most_energy) return std::nullopt;
  if (other.unexplained <= better_curve * best.unexplained + equal_curves) return std::nullopt;
  return best;
}

}  // namespace trace
