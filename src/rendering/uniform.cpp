#include "rendering/uniform.hpp"

#include "rendering/sample_sums.hpp"

namespace trace {

void render_uniform(FrameRenderer& frame, Film& film, int n, const Vec2& place) {
  frame.for_each_tile(16, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    SampleSums sums(frame, sampler);
    for (int j = y0; j < y1; ++j) {
      for (int i = x0; i < x1; ++i) {
        sums.begin(i, j);
        sums.add_grid(i, j, n, place);
      }
    }
    sums.finish([&](int i, int j, const Rgb& mean) { film.set(i, j, mean); });
  });
}

}  // namespace trace
