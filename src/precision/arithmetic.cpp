#include "precision/arithmetic.hpp"

#include <stdexcept>
#include <string>

#include "parallel/parallel.hpp"
#include "precision/render_as.hpp"
#include "scene/beyond_course.hpp"

namespace trace {

// A format with less could not be the truth of double.
static_assert(std::numeric_limits<long double>::digits >= 64);

ArithmeticPicture render_in(Arithmetic arithmetic, const Scene& scene, const SceneTree& tree,
                            const RenderOptions& options, int threads) {
  if (const std::string_view what = beyond_course(scene); !what.empty()) {
    throw std::invalid_argument("not in other arithmetics: " + std::string(what));
  }
  const int at_once = threads_or_all(threads);
  switch (arithmetic) {
    case Arithmetic::single:
      return precision::render_as<float>(scene, tree, options, at_once);
    case Arithmetic::working:
      return precision::render_as<double>(scene, tree, options, at_once);
    case Arithmetic::extended:
      break;
  }
  return precision::render_as<long double>(scene, tree, options, at_once);
}

ArithmeticPicture render_in(Arithmetic arithmetic, const Scene& scene, const RenderOptions& options,
                            int threads) {
  const SceneTree tree(scene, threads_or_all(threads), options.instruction_set);
  return render_in(arithmetic, scene, tree, options, threads);
}

}  // namespace trace
