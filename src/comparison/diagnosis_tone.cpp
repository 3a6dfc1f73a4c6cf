#include "comparison/diagnosis_tone.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparison/joint_histogram.hpp"

namespace trace {
namespace {

// Of the samples that moved, at most this share may disobey the curve. A true curve is obeyed by all but those that
// a renderer limited to one before it mixed them further (in mirrors).
constexpr double most_disobedient = 0.02;
// Distinct levels of the reference among the samples that moved: with fewer, any curve passes through them.
constexpr int fewest_levels = 8;
// A curve must leave this much less than any other kind of curve that is accepted as well.
constexpr double clearly_better = 4;

struct Fit {
  double parameter = 1;
  double unexplained = 1;
};

// The curve of the family with the least share of disobedient samples; among equals the middle of the plateau.
// Parameters run from `low` to `high` in equal ratios.
template <class Curve>
Fit fit(const JointHistogram& histogram, double low, double high, int steps, const Curve& curve) {
  Fit best;
  double first = low, last = low;
  for (int i = 0; i <= steps; ++i) {
    const double parameter = low * std::pow(high / low, static_cast<double>(i) / steps);
    const double left = histogram.disobedient([&](double v) { return curve(v, parameter); });
    // Plateaus end raggedly: a thousandth is no reason to move.
    if (left < best.unexplained - 0.001) {
      best.unexplained = left;
      first = last = parameter;
    } else if (left <= best.unexplained + 0.001) {
      last = parameter;
    }
  }
  best.parameter = std::sqrt(first * last);
  return best;
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

// A known exponent where it obeys as well as the best one.
std::string gamma_text(const JointHistogram& histogram, const Fit& gamma) {
  for (const double known : {2.2, 1.8, 2.0, 2.4}) {
    const double slack = gamma.unexplained + 0.005;
    if (histogram.disobedient([&](double v) { return power(v, 1 / known); }) <= slack)
      return fmt::format("gamma {} was applied", known);
    if (histogram.disobedient([&](double v) { return power(v, known); }) <= slack)
      return fmt::format("gamma {} was removed", known);
  }
  if (gamma.parameter < 1) return fmt::format("gamma {:.2f} was applied", 1 / gamma.parameter);
  return fmt::format("gamma {:.2f} was removed", gamma.parameter);
}

void consider(std::vector<Finding>& findings, Diagnosis::Kind kind, const std::string& text, double left) {
  if (left <= most_disobedient) findings.push_back({{kind, text}, left});
}

}  // namespace

std::optional<Finding> find_tone(const PicturePair& pair) {
  const JointHistogram histogram(pair);
  if (histogram.levels_that_moved() < fewest_levels) return std::nullopt;

  // Ratios of neighbouring parameters: 1 %, and 0.7 %, below what one level in 255 can tell apart.
  const Fit gamma = fit(histogram, 0.2, 5, 320, power);
  const Fit factor = fit(histogram, 0.05, 20, 850, [](double v, double f) { return v * f; });

  std::vector<Finding> findings;
  consider(findings, Diagnosis::Kind::gamma, gamma_text(histogram, gamma), gamma.unexplained);
  consider(findings, Diagnosis::Kind::gamma, "the sRGB curve was applied", histogram.disobedient(srgb));
  consider(findings, Diagnosis::Kind::gamma, "the sRGB curve was removed", histogram.disobedient(from_srgb));
  consider(findings, Diagnosis::Kind::brightness, fmt::format("brightness is scaled by {:.2f}", factor.parameter),
           factor.unexplained);
  if (findings.empty()) return std::nullopt;
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.unexplained < b.unexplained; });
  for (const Finding& other : findings) {
    if (other.diagnosis.kind != findings[0].diagnosis.kind &&
        other.unexplained < clearly_better * findings[0].unexplained + 0.001)
      return std::nullopt;
  }
  return findings[0];
}

}  // namespace trace
