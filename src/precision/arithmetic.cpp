#include "precision/arithmetic.hpp"

#include <algorithm>
#include <stdexcept>

#include "parallel/parallel.hpp"
#include "precision/render_as.hpp"

namespace trace {

// A format with less could not be the truth of double.
static_assert(std::numeric_limits<long double>::digits >= 64);

namespace {

bool knows(const Scene& scene, const Object& object) {
  return std::visit(
      [&](const auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, Box> || std::is_same_v<S, Square> || std::is_same_v<S, MeshId>) {
          return true;
        } else if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, Cylinder> ||
                             std::is_same_v<S, Cone>) {
          return !scene.materials[object.material].has_maps();
        } else {
          return false;
        }
      },
      object.shape);
}

}  // namespace

bool plain_tracer_knows(const Scene& scene) {
  return std::all_of(scene.objects.begin(), scene.objects.end(),
                     [&](const Object& object) { return knows(scene, object); });
}

ArithmeticPicture render_in(Arithmetic arithmetic, const Scene& scene, const SceneTree& tree,
                            const RenderOptions& options, int threads) {
  if (!plain_tracer_knows(scene)) throw std::invalid_argument("a scene that the plain tracer does not know");
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
