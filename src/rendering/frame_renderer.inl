#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>

namespace trace {

template <class Body>
void FrameRenderer::for_each_tile(int edge, Body&& body) {
  const int columns = (width() + edge - 1) / edge, rows = (height_ + edge - 1) / edge;
  tbb::parallel_for(
      tbb::blocked_range<std::int64_t>(0, std::int64_t{columns} * rows, 1),
      [&](const tbb::blocked_range<std::int64_t>& range) {
        const Sampler sampler(*this, counts_.local());
        for (std::int64_t tile = range.begin(); tile != range.end(); ++tile) {
          const int x0 = static_cast<int>(tile % columns) * edge, y0 = static_cast<int>(tile / columns) * edge;
          const int x1 = std::min(x0 + edge, width()), y1 = std::min(y0 + edge, height_);
          body(sampler, x0, y0, x1, y1);
          progress_.done += static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
        }
      },
      tbb::simple_partitioner());
}

}  // namespace trace
