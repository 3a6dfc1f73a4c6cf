#include "rendering/depth_pilot.hpp"

#include <chrono>
#include <cmath>

#include "rendering/frame_renderer.hpp"
#include "rendering/pilot_places.hpp"
#include "rendering/sample_sums.hpp"

namespace trace {
namespace {

constexpr std::size_t most_pixels = 4096;

// RMSE in levels.
double difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += glm::dot(a[k] - b[k], a[k] - b[k]);
  return 255 * std::sqrt(sum / (3 * static_cast<double>(a.size())));
}

}  // namespace

DepthPilot pilot_depth(const Scene& scene, const SceneTree& tree, const RenderOptions& options, int height,
                       int deepest, double enough, double most_rays, double most_seconds) {
  const auto width = static_cast<std::size_t>(options.width);
  const std::size_t total = width * static_cast<std::size_t>(height), count = std::min(total, most_pixels);
  // Single pixels say most of the picture; blocks of neighbours cost what the picture's own packets do.
  const std::size_t block = most_seconds < std::numeric_limits<double>::infinity() ? 4 : 1;
  const auto pixel = [&](std::size_t k) {
    const std::size_t of_block = block * block, blocks = std::max<std::size_t>(count / of_block, 1);
    const std::size_t place = pilot_place(std::min(k / of_block, blocks - 1), blocks, total),
                      inside = k % of_block;
    return std::pair(static_cast<int>(std::min(place % width + inside % block, width - 1)),
                     static_cast<int>(std::min(place / width + inside / block, total / width - 1)));
  };
  std::vector<std::vector<Rgb>> colors;
  DepthPilot result;
  std::uint64_t rays_before = 0;
  double all_seconds = 0;
  for (std::size_t rung = 0; rung < std::size(pilot_depths); ++rung) {
    RenderOptions at_depth = options;
    at_depth.depth = std::min(pilot_depths[rung], deepest);
    const auto begin = std::chrono::steady_clock::now();
    Progress progress;
    FrameRenderer frame(scene, tree, at_depth, height, threads_or_all(options.threads), progress);
    std::vector<Rgb> seen(count);
    frame.for_each_tile(
        static_cast<int>(count), 1, 64,
        [&](const FrameRenderer::Sampler& sampler, int first, int, int last, int) {
          SampleSums sums(frame, sampler);
          for (int k = first; k < last; ++k) {
            const auto [i, j] = pixel(static_cast<std::size_t>(k));
            sums.begin(i, j);
            sums.add_grid(i, j, 1);
          }
          int k = first;
          sums.finish([&](int, int, const Rgb& mean) { seen[static_cast<std::size_t>(k++)] = mean; });
        });
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const std::uint64_t rays = frame.counts().total();
    const auto samples = static_cast<double>(count);
    result.steps.push_back({at_depth.depth, 0, static_cast<double>(rays) / samples, spent.count() / samples});
    colors.push_back(std::move(seen));
    if (rung > 0) result.left = difference(colors[rung], colors[rung - 1]);
    if (rung > 0 && rays == rays_before) {  // no ray was left to go deeper: this step is the one before
      result.steps.pop_back();
      colors.pop_back();
      result.left = 0;
      break;
    }
    rays_before = rays;
    // Two steps in a row, for mirrors that face each other may show something new only every other time.
    const bool still =
        rung > 1 && result.left < enough && difference(colors[rung - 1], colors[rung - 2]) < enough;
    if (still || at_depth.depth == deepest) break;
    all_seconds += spent.count();
    if (all_seconds > most_seconds) {
      result.settled = false;
      break;
    }
    if (rung > 0 && result.steps.back().rays_per_sample > most_rays) {
      result.steps.pop_back();
      colors.pop_back();
      result.settled = result.left < enough;
      break;
    }
  }
  for (std::size_t rung = 0; rung < colors.size(); ++rung) {
    result.steps[rung].error = difference(colors[rung], colors.back());
  }
  return result;
}

}  // namespace trace
