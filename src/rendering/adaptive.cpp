#include "rendering/adaptive.hpp"

#include <algorithm>

#include "rendering/sample_sums.hpp"

namespace trace {
namespace {

constexpr int corner_tile = 16;
constexpr int edge = 64;  // of tiles whose contrasts are found at once
static_assert(corner_tile * corner_tile <= SampleBatch::capacity);

}  // namespace

CornerSamples::CornerSamples(FrameRenderer& frame)
    : columns_(frame.width() + 1),
      colors_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(frame.height() + 1)) {
  const double width = frame.width(), height = frame.height();
  const auto trace_tile = [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    SampleBatch batch;
    const auto for_each = [&](auto&& visit) { for_each_in_blocks(x0, y0, x1, y1, visit); };
    for_each([&](int i, int j) { batch.add(sampler.direction(i / width, j / height)); });
    sampler.trace(batch);
    std::size_t k = 0;
    for_each([&](int i, int j) {
      Rgb color = batch.left_out[k] ? Rgb(0) : batch.color(k);
      if (batch.left_out[k]) {
        const PartialRgb sample = sampler.at(i / width, j / height);
        frame.non_finite().watch(std::min(i, frame.width() - 1), std::min(j, frame.height() - 1), sample);
        color = sample.value;
      }
      color = clamped(color);
      colors_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(i)] = {static_cast<float>(color.x), static_cast<float>(color.y),
                                              static_cast<float>(color.z)};
      ++k;
    });
  };
  frame.for_each_tile(frame.width() + 1, frame.height() + 1, corner_tile, trace_tile);
}

Rgb CornerSamples::mean(int i, int j) const {
  const Color &a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
  return {(double{a.r} + b.r + c.r + d.r) / 4, (double{a.g} + b.g + c.g + d.g) / 4,
          (double{a.b} + b.b + c.b + d.b) / 4};
}

float CornerSamples::contrast(int i, int j) const {
  const Color &a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
  const auto range = [](float p, float q, float r, float s) {
    return std::max(std::max(p, q), std::max(r, s)) - std::min(std::min(p, q), std::min(r, s));
  };
  return 255 *
         std::max(range(a.r, b.r, c.r, d.r), std::max(range(a.g, b.g, c.g, d.g), range(a.b, b.b, c.b, d.b)));
}

std::vector<std::uint8_t> CornerSamples::contrasts(FrameRenderer& frame) const {
  const int width = frame.width(), height = frame.height();
  std::vector<std::uint8_t> bins(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  frame.for_each_tile(
      width, height, edge, [&](const FrameRenderer::Sampler&, int x0, int y0, int x1, int y1) {
        // With a border of one pixel, 0 outside the picture.
        std::array<std::array<float, edge + 2>, edge + 2> own{};
        for (int j = std::max(y0 - 1, 0); j < std::min(y1 + 1, height); ++j) {
          for (int i = std::max(x0 - 1, 0); i < std::min(x1 + 1, width); ++i) {
            own[static_cast<std::size_t>(j - y0 + 1)][static_cast<std::size_t>(i - x0 + 1)] = contrast(i, j);
          }
        }
        for (int j = y0; j < y1; ++j) {
          for (int i = x0; i < x1; ++i) {
            const auto y = static_cast<std::size_t>(j - y0 + 1), x = static_cast<std::size_t>(i - x0 + 1);
            float around = 0;
            for (std::size_t q = y - 1; q <= y + 1; ++q) {
              around = std::max(around, std::max(own[q][x - 1], std::max(own[q][x], own[q][x + 1])));
            }
            bins[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(i)] =
                static_cast<std::uint8_t>(contrast_bin(std::max(own[y][x], around / 4)));
          }
        }
      });
  return bins;
}

namespace {

class Refinement {
 public:
  Refinement(FrameRenderer& frame, Film& film, std::vector<std::uint8_t> contrasts,
             const GridByContrast& grids)
      : frame_(frame),
        film_(film),
        contrasts_(std::move(contrasts)),
        grids_(grids),
        found_(contrasts_.size()) {}

  void by_corners(const CornerSamples& corners) {
    frame_.for_each_tile(16, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
      SampleSums sums(frame_, sampler, true);
      for (int j = y0; j < y1; ++j) {
        for (int i = x0; i < x1; ++i) {
          if (const int n = grids_[contrasts_[index(i, j)]]) {
            sums.begin(i, j);
            sums.add_grid(i, j, n);
          } else {
            film_.set(i, j, corners.mean(i, j));
          }
        }
      }
      finish(sums);
    });
  }

  // What samples have found that corners do not show goes on in neighbours; so thin lines are followed.
  void follow() {
    std::vector<std::size_t> pixels;
    for (std::size_t k = 0; k < contrasts_.size(); ++k) {
      if (found_[k] > contrasts_[k]) pixels.push_back(k);
    }
    while (!pixels.empty()) {
      pixels = to_refine(pixels);
      frame_.for_each_tile(static_cast<int>(pixels.size()), 1, 16,
                           [&](const FrameRenderer::Sampler& sampler, int first, int, int last, int) {
                             SampleSums sums(frame_, sampler, true);
                             for (int k = first; k < last; ++k) {
                               const std::size_t pixel = pixels[static_cast<std::size_t>(k)];
                               const auto width = static_cast<std::size_t>(frame_.width());
                               const int i = static_cast<int>(pixel % width),
                                         j = static_cast<int>(pixel / width);
                               sums.begin(i, j);
                               sums.add_grid(i, j, grids_[contrasts_[pixel]]);
                             }
                             finish(sums);
                           });
    }
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(frame_.width()) +
           static_cast<std::size_t>(i);
  }

  void finish(SampleSums& sums) {
    sums.finish_with_ranges([&](int i, int j, const Rgb& mean, double range) {
      film_.set(i, j, mean);
      found_[index(i, j)] = static_cast<std::uint8_t>(contrast_bin(static_cast<float>(255 * range / 2)));
    });
  }

  // The neighbours of these pixels that deserve more samples for what was found there; each once. Their
  // contrast becomes that, so that a pixel is drawn again only for a larger one: at most as often as there
  // are steps.
  std::vector<std::size_t> to_refine(const std::vector<std::size_t>& pixels) {
    std::vector<std::size_t> result;
    for (const std::size_t pixel : pixels) {
      const int i = static_cast<int>(pixel % static_cast<std::size_t>(frame_.width()));
      const int j = static_cast<int>(pixel / static_cast<std::size_t>(frame_.width()));
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, frame_.height() - 1); ++y) {
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, frame_.width() - 1); ++x) {
          std::uint8_t& own = contrasts_[index(x, y)];
          if (grids_[found_[pixel]] <= grids_[own]) continue;
          own = found_[pixel];
          result.push_back(index(x, y));
        }
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  FrameRenderer& frame_;
  Film& film_;
  std::vector<std::uint8_t> contrasts_;
  const GridByContrast& grids_;
  std::vector<std::uint8_t> found_;  // bin of half the range of a pixel's samples; 0 where it has none
};

}  // namespace

void refine(FrameRenderer& frame, Film& film, const CornerSamples& corners,
            std::vector<std::uint8_t> contrasts, const GridByContrast& grids) {
  Refinement refinement(frame, film, std::move(contrasts), grids);
  refinement.by_corners(corners);
  refinement.follow();
}

void render_adaptive(FrameRenderer& frame, Film& film, const GridByContrast& grids) {
  const CornerSamples corners(frame);
  refine(frame, film, corners, corners.contrasts(frame), grids);
}

}  // namespace trace
