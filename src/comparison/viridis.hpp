// The colour map viridis by Stéfan van der Walt, Nathaniel Smith and Eric Firing (2015; CC0, in the public
// domain), made so that equal steps look equally large, to colour-blind people and in gray too.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace trace {

using MapColor = std::array<std::uint8_t, 3>;

// From 0, dark violet, over blue and green to 1, yellow. Straight between every 17th of the map's 256
// colours, which is never off by more than 2 of 255.
inline MapColor viridis(double t) {
  constexpr std::array<std::array<double, 3>, 16> knots{{{0.267004, 0.004874, 0.329415},
                                                         {0.282656, 0.100196, 0.422160},
                                                         {0.277134, 0.185228, 0.489898},
                                                         {0.253935, 0.265254, 0.529983},
                                                         {0.221989, 0.339161, 0.548752},
                                                         {0.190631, 0.407061, 0.556089},
                                                         {0.163625, 0.471133, 0.558148},
                                                         {0.139147, 0.533812, 0.555298},
                                                         {0.120565, 0.596422, 0.543611},
                                                         {0.134692, 0.658636, 0.517649},
                                                         {0.208030, 0.718701, 0.472873},
                                                         {0.327796, 0.773980, 0.406640},
                                                         {0.477504, 0.821444, 0.318195},
                                                         {0.647257, 0.858400, 0.209861},
                                                         {0.824940, 0.884720, 0.106217},
                                                         {0.993248, 0.906157, 0.143936}}};
  const double place = std::clamp(t, 0.0, 1.0) * (knots.size() - 1);
  const std::size_t knot = std::min<std::size_t>(static_cast<std::size_t>(place), knots.size() - 2);
  const double part = place - static_cast<double>(knot);
  MapColor color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(
        255 * (knots[knot][c] + part * (knots[knot + 1][c] - knots[knot][c])) + 0.5);
  return color;
}

}  // namespace trace
