// What a study varies.
#pragma once

#include <array>
#include <string_view>

namespace trace {

enum class Axis {
  samples,
  adaptive,
  budget,
  course_adaptive,
  depth,
  contribution,
  resolution,
  arithmetic,
  needs,
  patterns
};

struct AxisText {
  Axis axis;
  std::string_view name;   // in results and on the command line
  std::string_view title;  // for people
  std::string_view text;
};

inline constexpr std::array<AxisText, 10> axis_texts{{
    {Axis::samples, "samples", "Samples a pixel",
     "the same number of samples in every pixel: one at its corner, as the course draws, then n x n in the "
     "middles of equal "
     "parts"},
    {Axis::adaptive, "adaptive", "Adaptive samples",
     "one sample at each corner, then n x n where the corners differ, n by how much; the number is about the "
     "error in levels "
     "that is left in a pixel on an edge"},
    {Axis::budget, "budget", "Error budget",
     "the fastest setting that is predicted to be off by at most so many levels; what predicting takes is "
     "part of the "
     "time"},
    {Axis::course_adaptive, "course", "The course's antialiasing",
     "n x n samples in pixels that differ from a neighbour by more than a threshold, in thousandths"},
    {Axis::depth, "depth", "Recursion depth", "bounces of reflection and refraction, one sample a pixel"},
    {Axis::contribution, "contribution", "Contribution threshold",
     "rays that would add less than a share of what they see end, one sample a pixel"},
    {Axis::resolution, "resolution", "Resolution", "a smaller picture, enlarged between its samples"},
    {Axis::arithmetic, "arithmetic", "Arithmetic",
     "a plain tracer of one ray at a time in float, double and extended precision, which is its truth; one "
     "sample a pixel"},
    {Axis::needs, "needs", "Only what is needed",
     "everything modelled, needed or not, against only what the scene needs; the picture is the same"},
    {Axis::patterns, "patterns", "Patterns of samples",
     "nine points of every pixel, shared with its neighbours; the grid of 2 x 2 is among the samples a "
     "pixel, "
     "the "
     "recursive pattern is the adaptive one"},
}};

inline const AxisText& text_of(Axis axis) {
  return axis_texts[static_cast<std::size_t>(axis)];
}

}  // namespace trace
