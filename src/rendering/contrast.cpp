#include "rendering/contrast.hpp"

#include <cmath>

namespace trace {

GridByContrast grids_for_threshold(double threshold, int most) {
  GridByContrast result{};
  for (int bin = 1; bin < contrast_bins; ++bin) {
    const double middle = contrast_of_bin(bin) * 1.2;
    const double wanted = std::pow(middle / threshold, 2.0 / 3);
    double nearest = 0;
    for (const std::uint8_t n : grid_ladder) {
      if (n > most) break;
      // On a scale of ratios.
      const double distance = std::abs(std::log(wanted / std::max<int>(n, 1)));
      if (n == 0 || distance < nearest) {
        nearest = distance;
        result[static_cast<std::size_t>(bin)] = n;
      }
    }
  }
  return result;
}

}  // namespace trace
