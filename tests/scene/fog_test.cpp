#include "scene/make_fog.hpp"

#include <catch2/catch.hpp>

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

parser::Scalar number_at(double value, std::uint32_t at) {
  return {value, {at, at + 3}};
}

parser::Fog white_fog() {
  parser::Fog fog;
  fog.color = parser::Vector3{{1, 1, 1}, {}};
  fog.keyword = {0, 3};
  return fog;
}

Fog good_fog(const parser::Fog& said) {
  parser::Diagnostics diagnostics;
  const std::optional<Fog> fog = make_fog(said, diagnostics);
  CHECK(diagnostics.all().empty());
  REQUIRE(fog);
  return *fog;
}

std::string fog_error(const parser::Fog& said) {
  parser::Diagnostics diagnostics;
  CHECK_FALSE(make_fog(said, diagnostics));
  REQUIRE(diagnostics.all().size() == 1);
  return diagnostics.all()[0].text;
}

const Ray along_z{{1, 2, 3}, {0, 0, -1}};

}  // namespace

TEST_CASE("fog by distance begins at its start and hides all at its end and what is nothing") {
  parser::Fog said = white_fog();
  said.start = number_at(2, 10);
  said.end = number_at(10, 20);
  const Fog fog = good_fog(said);
  CHECK(fog.part(along_z, 1) == 0);
  CHECK(fog.part(along_z, 4) == about(0.25));
  CHECK(fog.part(along_z, 10) == 1);
  CHECK(fog.part(along_z, 11) == 1);
  CHECK(fog.part(along_z, -1) == 1);
}

TEST_CASE("fog along an axis counts from the world's origin, and may grow against the axis") {
  parser::Fog said = white_fog();
  said.axis = parser::Vector3{{0, 0, 5}, {}};
  said.start = number_at(-60, 10);
  said.end = number_at(-200, 20);
  const Fog fog = good_fog(said);
  CHECK(fog.part(along_z, 13) == 0);            // z = -10
  CHECK(fog.part(along_z, 98) == about(0.25));  // z = -95
  CHECK(fog.part(along_z, 400) == 1);
  CHECK(fog.part(along_z, -1) == 1);  // nothing, towards -z
  CHECK(fog.part({{0, 0, -95}, {0, 0, 1}}, -1) == 0);
  CHECK(fog.part({{0, 0, -95}, {1, 0, 0}}, -1) == about(0.25));
}

TEST_CASE("exponential fog leaves exp(-density * depth)") {
  parser::Fog said = white_fog();
  said.density = number_at(0.25, 10);
  const Fog fog = good_fog(said);
  CHECK(fog.part(along_z, 0) == 0);
  CHECK(fog.part(along_z, 8) == about(1 - std::exp(-2.0)));
  CHECK(fog.part(along_z, -1) == 1);
  said.start = number_at(4, 20);
  CHECK(good_fog(said).part(along_z, 8) == about(1 - std::exp(-1.0)));
  CHECK(good_fog(said).part(along_z, 3) == 0);
  said.density = number_at(0, 10);
  CHECK(good_fog(said).part(along_z, -1) == 0);
}

TEST_CASE("fog that is not said completely, or twice, is an error") {
  parser::Fog said = white_fog();
  CHECK(fog_error(said) == "fog has no 'end' and no 'density'");
  said.start = number_at(5, 10);
  said.end = number_at(5, 20);
  CHECK(fog_error(said) == "'end' must be greater than 'start'");
  said.axis = parser::Vector3{{0, 1, 0}, {}};
  CHECK(fog_error(said) == "'end' must not be 'start'");
  said.density = number_at(1, 30);
  CHECK(fog_error(said) == "fog has both 'end' and 'density': it is linear or exponential");
  said.end.reset();
  said.density = number_at(-1, 30);
  CHECK(fog_error(said) == "'density' must not be negative");
  said.density = number_at(1, 30);
  said.axis = parser::Vector3{{0, 0, 0}, {}};
  CHECK(fog_error(said) == "'axis' must be longer than 0");
  said.axis.reset();
  said.color.reset();
  CHECK(fog_error(said) == "fog has no 'color'");
}
