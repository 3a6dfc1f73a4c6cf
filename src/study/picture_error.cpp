#include "study/picture_error.hpp"

#include <algorithm>
#include <cmath>

#include "comparison/error_sum.hpp"

namespace trace {

PictureError picture_error(const ColorImage& picture, const ColorImage& truth) {
  ErrorSum sum;
  for (std::size_t k = 0; k < picture.samples().size(); ++k) {
    sum.add(double{picture.samples()[k]} - truth.samples()[k]);
  }
  sum.count = picture.samples().size();
  const ErrorFigures figures = sum.figures(255);
  return {figures.root_mean_square, figures.mean_absolute, figures.largest};
}

ColorImage mean(const ColorImage& a, const ColorImage& b) {
  ColorImage result(a.width(), a.height());
  for (std::size_t k = 0; k < a.samples().size(); ++k) {
    result.samples()[k] = static_cast<float>((double{a.samples()[k]} + b.samples()[k]) / 2);
  }
  return result;
}

ColorImage enlarged(const ColorImage& picture, int width, int height) {
  ColorImage result(width, height);
  // Places count from the lower left; the last row and column go on as they are.
  const auto around = [](double place, int count, int& low, int& high) {
    low = std::min(static_cast<int>(place), count - 1);
    high = std::min(low + 1, count - 1);
    return std::min(place - low, 1.0);
  };
  for (int j = 0; j < height; ++j) {
    int below, above;
    const double t = around((j + 0.5) * picture.height() / height, picture.height(), below, above);
    for (int i = 0; i < width; ++i) {
      int left, right;
      const double s = around((i + 0.5) * picture.width() / width, picture.width(), left, right);
      const auto at = [&](int x, int y) { return picture.at(x, picture.height() - 1 - y); };
      result.set(i, height - 1 - j,
                 (1 - t) * ((1 - s) * at(left, below) + s * at(right, below)) +
                     t * ((1 - s) * at(left, above) + s * at(right, above)));
    }
  }
  return result;
}

}  // namespace trace
