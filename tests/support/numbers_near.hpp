// Comparison of vectors in tests, and how they are shown where a test fails.
#pragma once

#include <catch2/catch.hpp>
#include <ostream>
#include <sstream>

#include "geometry/vector.hpp"

namespace trace::test {

// Equal in every component up to an absolute error.
struct Near {
  Vec3 value;
  double error = 1e-12;

  friend bool operator==(const Vec3& a, const Near& b) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(a[axis] - b.value[axis]) <= b.error)) return false;
    }
    return true;
  }
};

inline Near near(double x, double y, double z, double error = 1e-12) {
  return {Vec3(x, y, z), error};
}
inline Near near(const Vec3& v, double error = 1e-12) {
  return {v, error};
}

inline Approx about(double value) {
  return Approx(value).epsilon(1e-12).margin(1e-12);
}

inline std::string shown(const Vec3& v) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

}  // namespace trace::test

namespace Catch {

template <>
struct StringMaker<trace::Vec3> {
  static std::string convert(const trace::Vec3& v) { return trace::test::shown(v); }
};
template <>
struct StringMaker<trace::Vec2> {
  static std::string convert(const trace::Vec2& v) { return trace::test::shown(trace::Vec3(v, 0)); }
};
template <>
struct StringMaker<trace::test::Near> {
  static std::string convert(const trace::test::Near& n) { return trace::test::shown(n.value); }
};

}  // namespace Catch
