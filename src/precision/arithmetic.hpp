// One picture in one kind of number: what a ray tracer loses in floats, and what doubles lose themselves.
#pragma once

#include <vector>

#include "acceleration/scene_tree.hpp"
#include "rendering/options.hpp"
#include "scene/scene.hpp"
#include "shading/ray_counts.hpp"

namespace trace {

enum class Arithmetic {
  single,    // float: 24 bits of significand
  working,   // double, what the program computes in: 53 bits
  extended,  // long double, on x86-64 the x87's format: 64 bits of significand
};

struct ArithmeticPicture {
  int width = 0, height = 0;
  std::vector<double> colors;  // red, green, blue of each pixel, rows from the top; in [0, 1], not quantised
  double seconds = 0;          // of wall clock for the rays alone
  RayCounts rays;
};

// The picture by a plain tracer of one ray at a time, the same for any kind of number: the formulas of
// docs/language.md in the forms of textbooks (Moeller and Trumbore, the quadratic formula without
// cancellation of its terms, slabs), without the exact tests that the program falls back on. The places,
// matrices, colours and hierarchies of `scene` are those of the program; each is carried to the kind of
// number once, so what differs between two pictures is the arithmetic of the rays and of nothing else.
//
// One sample a pixel, at its corner, as render() takes it. Of `options` width, depth and the switches of
// shading count; antialiasing, blocks, instruction set and threads do not. Options must be within the limits
// of rendering/options.hpp and picture_height() within those of a picture. An undefined channel is black.
// The scene must be one that is drawn by the rules of utexas (DialectRules::draws_as_utexas()).
// The same numbers for any number of threads (0: as many as the machine has).
//
// Throws std::invalid_argument for a scene with anything that the course's language does not have
// (scene/beyond_course.hpp).
ArithmeticPicture render_in(Arithmetic arithmetic, const Scene& scene, const SceneTree& tree,
                            const RenderOptions& options, int threads);

// The same, with hierarchies of its own.
ArithmeticPicture render_in(Arithmetic arithmetic, const Scene& scene, const RenderOptions& options,
                            int threads);

}  // namespace trace
