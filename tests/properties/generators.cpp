#include "tests/properties/generators.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <ostream>

#include "tests/support/numbers_near.hpp"

namespace trace::test {
namespace {

// 0, -1, 1, -2, 2, ... times `step`, so that shrinking goes towards zero.
rc::Gen<double> multiple(int count, double step) {
  return rc::gen::map(rc::gen::inRange(0, 2 * count + 1), [step](int k) {
    const double magnitude = (k + 1) / 2;
    return (k % 2 == 0 ? magnitude : -magnitude) * step;
  });
}

template <class Value>
rc::Gen<Vec3> three(const rc::Gen<Value>& one) {
  return rc::gen::map(rc::gen::tuple(one, one, one), [](const std::tuple<double, double, double>& t) {
    return Vec3(std::get<0>(t), std::get<1>(t), std::get<2>(t));
  });
}

rc::Gen<Vec3> direction() {
  return rc::gen::map(rc::gen::suchThat(three(coordinate()), [](const Vec3& v) { return !is_zero(v); }),
                      [](const Vec3& v) { return glm::normalize(v); });
}

}  // namespace

rc::Gen<double> coordinate() {
  return rc::gen::oneOf(multiple(32, 0.25), multiple(8 << 20, 0x1p-20),
                        multiple(6 << 20, 0x1.5555555555555p-20));
}

rc::Gen<Place> place() {
  return rc::gen::map(three(coordinate()), [](const Vec3& v) { return Place{v}; });
}

rc::Gen<Place> place_within() {
  return rc::gen::map(three(multiple(63, 0x1p-6)), [](const Vec3& v) { return Place{v}; });
}

rc::Gen<Heading> heading() {
  return rc::gen::map(direction(), [](const Vec3& v) { return Heading{v}; });
}

rc::Gen<Ray> aimed_ray() {
  return rc::gen::apply(
      [](const Place& origin, const Place& target) {
        const Vec3 way = 1.25 * target.at - origin.at;
        return Ray{origin.at, is_zero(way) ? Vec3(0, 0, 1) : glm::normalize(way)};
      },
      place(), place_within());
}

rc::Gen<Transforms> transforms() {
  // 1, -1, 9/8, -9/8, ... and their inverses.
  const auto scale =
      rc::gen::map(rc::gen::tuple(multiple(56, 0.125), rc::gen::arbitrary<bool>()), [](const auto& t) {
        const double step = std::get<0>(t);
        const double factor = step < 0 ? step - 1 : step + 1;
        return std::get<1>(t) ? 1 / factor : factor;
      });
  return rc::gen::map(rc::gen::tuple(three(coordinate()), direction(), three(scale), coordinate()),
                      [](const auto& t) {
                        return Transforms{std::get<0>(t), std::get<1>(t), std::get<2>(t), std::get<3>(t)};
                      });
}

Mat4 Transforms::matrix() const {
  return glm::scale(glm::rotate(glm::translate(Mat4(1), move), angle, axis), scale);
}

void showValue(const Place& value, std::ostream& out) {
  out << shown(value.at);
}

void showValue(const Heading& value, std::ostream& out) {
  out << "along " << shown(value.along);
}

void showValue(const Transforms& value, std::ostream& out) {
  out << "translate " << shown(value.move) << " rotate " << shown(value.axis) << " by " << value.angle
      << " scale " << shown(value.scale);
}

}  // namespace trace::test

namespace trace {

void showValue(const Ray& value, std::ostream& out) {
  out << "from " << test::shown(value.origin) << " along " << test::shown(value.direction);
}

}  // namespace trace
