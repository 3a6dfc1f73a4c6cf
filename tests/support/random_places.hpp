// Random places of the scene graph, in doubles and exactly.
#pragma once

#include <random>

#include "geometry/placement.hpp"
#include "tests/support/quad_matrix.hpp"

namespace trace::test {

struct RandomPlace {
  Placement placement;
  QuadTransform exact;
};

class RandomPlaces {
 public:
  explicit RandomPlaces(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Either sign, a size from 10^low to 10^high.
  double of_size(double low, double high) {
    return std::pow(10.0, between(low, high)) * (between(0, 1) < 0.5 ? -1 : 1);
  }
  Vec3 vector_of_size(double low, double high) {
    return {of_size(low, high), of_size(low, high), of_size(low, high)};
  }

  // 1 to `depth` transforms, one inside another. Scales, with mirrors, are from 10^-scale to 10^scale.
  RandomPlace place(int depth, double scale) {
    RandomPlace result;
    const int count = std::uniform_int_distribution<int>(1, depth)(random_);
    for (int i = 0; i < count; ++i) add(result, scale);
    return result;
  }

 private:
  void add(RandomPlace& to, double scale) {
    LocalTransform local;
    QuadTransform exact;
    switch (std::uniform_int_distribution<int>(0, 3)(random_)) {
      case 0: {
        const Vec3 offset = vector_of_size(-9, 9);
        local = translation(offset);
        exact = QuadTransform::translation(offset);
        break;
      }
      case 1: {
        const Vec3 factors =
            between(0, 1) < 0.5 ? vector_of_size(-scale, scale) : Vec3(of_size(-scale, scale));
        local = scaling(factors);
        exact = QuadTransform::scaling(factors);
        break;
      }
      default: {
        const Vec3 axis = vector_of_size(-2, 2);
        const double angle = between(-7, 7);
        local = rotation(axis, angle);
        exact = QuadTransform::rotation(axis, angle);
      }
    }
    to.placement = to.placement.inside(local);
    to.exact = to.exact.inside(exact);
  }

  std::mt19937 random_;
};

}  // namespace trace::test
