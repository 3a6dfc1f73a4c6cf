// A picture in the kind of number T: float, double or long double.
#pragma once

#include "acceleration/scene_tree.hpp"
#include "precision/arithmetic.hpp"

namespace trace::precision {

// `tree` is of `scene`; at least one thread.
template <class T>
ArithmeticPicture render_as(const Scene& scene, const SceneTree& tree, const RenderOptions& options,
                            int threads);

}  // namespace trace::precision
