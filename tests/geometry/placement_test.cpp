// Inverses composed from inverses, and the bound of their error, against 113 bits.
#include "geometry/placement.hpp"

#include <catch2/catch.hpp>

#include "tests/support/random_places.hpp"

using namespace trace;
using namespace trace::test;

namespace {

double largest_entry(const Mat4& m) {
  double size = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) size = std::max(size, std::abs(m[column][row]));
  }
  return size;
}

bool holds(const BoundedMatrix& claimed, const QuadMatrix& truth) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const Quad exact = truth.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      if (!(magnitude(exact - claimed.value[column][row]) <= claimed.error[column][row])) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("the inverse of every transform is within its bound") {
  RandomPlaces random(1);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 axis = random.vector_of_size(-3, 3), factors = random.vector_of_size(-9, 9);
    const double angle = i % 2 == 0 ? random.between(-7, 7) : random.of_size(-12, 0);
    if (!holds(rotation(axis, angle).inverse, QuadTransform::rotation(axis, angle).inverse)) ++wrong;
    if (!holds(scaling(factors).inverse, QuadTransform::scaling(factors).inverse)) ++wrong;
    if (!holds(translation(factors).inverse, QuadTransform::translation(factors).inverse)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the inverse of a place 1 to 20 transforms deep is within its bound") {
  RandomPlaces random(2);
  int wrong = 0, reliable = 0;
  for (int i = 0; i < 20'000; ++i) {
    const RandomPlace r = random.place(20, i % 2 == 0 ? 1 : 9);
    if (!r.placement.reliable()) continue;
    ++reliable;
    if (!holds(r.placement.to_object(), r.exact.inverse)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(reliable > 19'000);
}

TEST_CASE("the inverse of a matrix given by its numbers is within its bound") {
  RandomPlaces random(3);
  int wrong = 0, bounded = 0;
  for (int i = 0; i < 20'000; ++i) {
    Mat4 m(1);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < (i % 3 == 0 ? 4 : 3); ++row) m[column][row] = random.of_size(-2, 2);
    }
    const BoundedMatrix inverse = bounded_inverse(m);
    if (!reliable(inverse, m)) continue;
    ++bounded;
    // x m = 1 + r, so x - m^-1 = r m^-1 = r x - r (x - m^-1): the last term is below the bound's own slack.
    const QuadMatrix x(inverse.value), product = x * QuadMatrix(m);
    QuadMatrix residual = product;
    for (std::size_t k = 0; k < 4; ++k) residual.rows[k][k] -= 1;
    QuadMatrix first = residual * x, second = residual * first, third = residual * second, truth;
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 4; ++c) {
        truth.rows[r][c] = x.rows[r][c] - first.rows[r][c] + second.rows[r][c] - third.rows[r][c];
      }
    }
    if (!holds(inverse, truth)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(bounded > 19'000);
}

TEST_CASE("a matrix whose rows depend on one another has no inverse, whatever rounding makes of them") {
  for (const Mat4& m : {Mat4(1, 4, 7, 0, 2, 5, 8, 0, 3, 6, 9, 0, 0, 0, 0, 1),
                        Mat4(0.1, 0.2, 0.3, 0, 0.2, 0.4, 0.6, 0, 1, 5, 2, 0, 4, 5, 6, 1), Mat4(0)}) {
    CHECK_FALSE(reliable(bounded_inverse(m), m));
  }
  const Mat4 regular(1, 4, 7, 0, 2, 5, 8, 0, 3, 6, 10, 0, 0, 0, 0, 1);
  CHECK(reliable(bounded_inverse(regular), regular));
}

TEST_CASE("12 nested rotations, scales and translations and their undoing are the identity within 1e-12") {
  Placement place;
  for (int i = 0; i < 12; ++i) {
    place = place.inside(rotation({1, i, 2}, 0.3 + i));
    place = place.inside(scaling({2, 0.5 + i, 3}));
    place = place.inside(translation({i, 1.5, -i}));
    // and undone one by one
    place = place.inside(translation({-i, -1.5, i}));
    place = place.inside(scaling({1 / 2.0, 1 / (0.5 + i), 1 / 3.0}));
    place = place.inside(rotation({1, i, 2}, -0.3 - i));
  }
  CHECK(largest_entry(place.to_world() - Mat4(1)) < 1e-12);
  CHECK(largest_entry(place.to_object().value - Mat4(1)) < 1e-12);
  CHECK(place.reliable());
}

TEST_CASE("12 rotations, scales and translations undone in reverse order are the identity within 1e-12") {
  Placement place;
  for (int i = 0; i < 4; ++i) {
    place = place.inside(rotation({1, i, 2}, 0.3 + i));
    place = place.inside(scaling({2, 0.5 + i, 3}));
    place = place.inside(translation({i, 1.5, -i}));
  }
  for (int i = 3; i >= 0; --i) {
    place = place.inside(translation({-i, -1.5, i}));
    place = place.inside(scaling({1 / 2.0, 1 / (0.5 + i), 1 / 3.0}));
    place = place.inside(rotation({1, i, 2}, -0.3 - i));
  }
  CHECK(largest_entry(place.to_world() - Mat4(1)) < 1e-12);
  CHECK(largest_entry(place.to_object().value - Mat4(1)) < 1e-12);
}

TEST_CASE("10 000 nested rotations and their undoing are the identity within a bound that stays small") {
  for (const double angle : {1e-4, 1.0}) {
    Placement place;
    const auto axis = [](int i) { return Vec3(1 + i % 7, i % 5, 3 - i % 11); };
    for (int i = 0; i < 10'000; ++i) place = place.inside(rotation(axis(i), angle));
    for (int i = 9'999; i >= 0; --i) place = place.inside(rotation(axis(i), -angle));
    INFO(angle << ": bound " << largest_entry(place.to_object().error) << ", off by "
               << largest_entry(place.to_object().value - Mat4(1)));
    CHECK(holds(place.to_object(), QuadMatrix()));
    CHECK(largest_entry(place.to_object().error) < 1e-10);
  }
}

TEST_CASE("translations and scales by powers of two have exact inverses with a bound of 0") {
  Placement place = Placement().inside(translation({1, 2, 3})).inside(scaling({2, -4, 0.5}));
  CHECK(largest_entry(place.to_object().error) == 0);
  CHECK(place.to_object().value * Vec4(3, -2, 3.5, 1) == Vec4(1, 1, 1, 1));
}

TEST_CASE("the axis of a rotation may be of any length") {
  for (const double length : {1e-300, 1e-200, 1e200, 1.7e308}) {
    const Mat4 m = rotation(Vec3(0, 0, length), std::acos(-1.0) / 2).matrix;
    CHECK(std::abs(m[0].x) < 1e-15);
    CHECK(m[0].y == 1);
    CHECK(m[1].x == -1);
    CHECK(m[2].z == 1);
  }
}
