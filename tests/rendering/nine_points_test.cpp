// The nine points of each pixel.
#include <catch2/catch.hpp>

#include "rendering/pixel.hpp"
#include "rendering/render.hpp"
#include "tests/rendering/sampled_scenes.hpp"

namespace trace::test {

namespace {

Rendered nine_point_picture(const Scene& scene, int width, int threads, InstructionSet set) {
  RenderOptions options;
  options.width = width;
  options.threads = threads;
  options.instruction_set = set;
  options.keep_colors = true;
  options.sampling.nine_points = true;
  Progress progress;
  return render(scene, SceneTree(scene), options, progress);
}

}  // namespace

TEST_CASE("with nine points each pixel is the mean of its corners, the middles of its edges and its centre") {
  const Scene scene = mixed_scene();
  const int width = 37;
  const Rendered nine = nine_point_picture(scene, width, 2, best_instruction_set());
  RenderOptions options;
  options.width = width;
  const SceneTree tree(scene);
  const TracedScene traced(scene, tree, options.shading);
  const RayCaster caster(scene.camera);
  const int height = nine.image.height;
  RayCounts counts;
  const WhittedTracer tracer(traced, counts);
  for (int j = 0; j < height; j += 5) {
    for (int i = 0; i < width; i += 3) {
      Rgb sum(0);
      for (const double y : {0.0, 0.5, 1.0}) {
        for (const double x : {0.0, 0.5, 1.0}) {
          const PartialRgb color =
              tracer.trace(caster.cast((i + x) / width, (j + y) / height), options.depth);
          sum += clamped(color.value);
        }
      }
      const Rgb mean = nine.colors.at(i, height - 1 - j);
      INFO(i << " " << j);
      CHECK(largest(mean - sum / 9.0) <= 0x1p-24);  // the colours are kept as floats
    }
  }
}

TEST_CASE("pictures of nine points do not depend on threads or instructions") {
  const Scene scene = mixed_scene();
  const Rendered one = nine_point_picture(scene, 50, 1, InstructionSet::baseline);
  CHECK(one.image.rgb == nine_point_picture(scene, 50, 2, best_instruction_set()).image.rgb);
}

}  // namespace trace::test
