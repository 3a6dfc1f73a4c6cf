// Primitives of the dialects: attributes, defaults, errors, and which of them take maps.
#include "scene/make_shape.hpp"

#include "scene/shape.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

using Kind = parser::Quadric::Kind;

parser::Scalar number(double value, std::uint32_t place = 0) {
  return {value, {place, place + 1}};
}

Built built_of(PrimitiveShape shape) {
  Describe d;
  d.top(primitive(std::move(shape)));
  return build(d);
}

template <class S>
S only(const Built& built) {
  REQUIRE_FALSE(built.diagnostics.has_errors());
  return std::get<S>(built.scene.objects.at(0).shape);
}

// Whether a place is on it, as far as a ray through it along `direction` tells.
template <class S>
bool goes_through(const S& shape, const Vec3& place, const Vec3& direction) {
  const auto hit = meet(shape, place - 3.0 * glm::normalize(direction), direction);
  return hit && std::abs(hit->t - 3) < 1e-9;
}

std::string error_of(PrimitiveShape shape) {
  const Built built = built_of(std::move(shape));
  REQUIRE(built.diagnostics.error_count() == 1);
  CHECK(built.scene.objects.empty());
  const auto& error = built.diagnostics.all().at(0);
  return std::to_string(error.span.begin) + ": " + error.text;
}

}  // namespace

TEST_CASE("a torus that says nothing has radii 1 and 0.2") {
  const Torus torus = only<Torus>(built_of(parser::Torus{}));
  CHECK((torus.major() == 1 && torus.minor() == 0.2));
  const Torus other = only<Torus>(built_of(parser::Torus{number(3), number(4)}));
  CHECK((other.major() == 3 && other.minor() == 4));
}

TEST_CASE("a plane that says nothing is z = 0") {
  CHECK(goes_through(only<Plane>(built_of(parser::Plane{})), {5, 6, 0}, {0, 0, -1}));
  parser::Plane said;
  said.point = parser::Vector3{{0, 2, 0}, {}};
  said.normal = parser::Vector3{{0, -3, 0}, {}};
  CHECK(goes_through(only<Plane>(built_of(said)), {5, 2, 7}, {0, -1, 0}));
}

TEST_CASE("a cylinder is a tube where it says capped = false") {
  CHECK_FALSE(built_of(parser::Cylinder{}).scene.objects.empty());
  only<Cylinder>(built_of(parser::Cylinder{}));
  only<Cylinder>(built_of(parser::Cylinder{parser::Located<bool>{true, {}}}));
  only<Tube>(built_of(parser::Cylinder{parser::Located<bool>{false, {}}}));
}

TEST_CASE("a paraboloid stands on its tip along y, from lower to upper bound") {
  parser::Quadric said;
  said.kind = Kind::paraboloid;
  const Quadric plain = only<Quadric>(built_of(said));
  CHECK(goes_through(plain, {0.5, 0.25, 0}, {-1, 0, 0}));
  CHECK(goes_through(plain, {0, 1, 1}, {0, 0, -1}));
  CHECK_FALSE(meet(plain, {5, 1.01, 0}, {-1, 0, 0}));
  said.a = number(0.5);
  said.b = number(1.1);
  said.lower_bound = number(1.5);
  said.upper_bound = number(2);
  const Built built = built_of(said);
  const Quadric cut = only<Quadric>(built);
  CHECK(goes_through(cut, {0.5 * std::sqrt(1.75), 1.75, 0}, {-1, 0, 0}));
  CHECK(goes_through(cut, {0, 1.75, 1.1 * std::sqrt(1.75)}, {0, 0, -1}));
  CHECK_FALSE(meet(cut, {5, 1.4, 0}, {-1, 0, 0}));
  const Bounds& bounds = built.scene.objects[0].bounds;
  CHECK(bounds.max == near(0.5 * std::sqrt(2.0), 2, 1.1 * std::sqrt(2.0), 1e-9));
  CHECK(bounds.min == near(-0.5 * std::sqrt(2.0), 1.5, -1.1 * std::sqrt(2.0), 1e-9));
}

TEST_CASE("the rim of a paraboloid is within its bounds") {
  parser::Quadric said;
  said.kind = Kind::paraboloid;
  const double high = GENERATE(1e-6, 0.3, 2.0, 1e7);
  said.upper_bound = number(high);
  said.a = number(0.7);
  const Built built = built_of(said);
  const Vec3 rim(0.7 * std::sqrt(high), high, 0);
  const Bounds& bounds = built.scene.objects.at(0).bounds;
  CHECK((rim.x < bounds.max.x && rim.y <= bounds.max.y));
}

TEST_CASE("the fixed quadrics have the equations of their names") {
  parser::Quadric said;
  said.kind = Kind::hyperboloid;
  CHECK(goes_through(only<Quadric>(built_of(said)), {std::sqrt(5.0), 0, 2}, {-1, 0, 0}));
  said.type_x = number(1);
  CHECK(goes_through(only<Quadric>(built_of(said)), {2, std::sqrt(5.0), 0}, {0, -1, 0}));
  said = {};
  said.kind = Kind::hyperbolic;
  CHECK(goes_through(only<Quadric>(built_of(said)), {std::sqrt(5.0), 2, 0}, {-1, 0, 0}));
  CHECK_FALSE(meet(only<Quadric>(built_of(said)), {0, 5, 0}, {0, -1, 0}));
  said = {};
  said.kind = Kind::hyperbolic_paraboloid;
  CHECK(goes_through(only<Quadric>(built_of(said)), {3, 2, 5}, {0, 0, -1}));
  said = {};
  CHECK(goes_through(only<Quadric>(built_of(said)), {1, 1, 1}, {0, 0, -1}));
  CHECK(goes_through(only<Quadric>(built_of(said)), {1, 0, 0}, {-1, 0, 0}));
}

TEST_CASE(
    "a general quadric takes its ten coefficients in the order of the squares, products, x, y, z and 1") {
  parser::Quadric said;
  said.coefficients = {1, 2, 3, 4, 5, 6, 7, 8, 9, -45};  // (1, 1, 1) makes all of them together 0
  said.coefficients_span = parser::Span{3, 9};
  CHECK(goes_through(only<Quadric>(built_of(said)), {1, 1, 1}, {-1, -2, -0.5}));
}

TEST_CASE("what describes no surface is an error at its place") {
  CHECK(error_of(parser::Torus{number(0, 7), number(1)}) == "7: the radii of a torus must be greater than 0");
  CHECK(error_of(parser::Torus{{}, number(-1, 9)}) == "9: the radii of a torus must be greater than 0");
  parser::Plane plane;
  plane.normal = parser::Vector3{{0, 0, 0}, {4, 11}};
  CHECK(error_of(plane) == "4: the normal of a plane must not be zero");
  parser::Quadric quadric;
  quadric.coefficients = std::vector<double>(9, 1);
  quadric.coefficients_span = parser::Span{5, 8};
  CHECK(error_of(quadric) == "5: a quadric has ten coefficients, this one has 9");
  quadric.coefficients = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  CHECK(error_of(quadric) == "5: a quadric needs a coefficient of x, y or z that is not 0");
  quadric = {};
  quadric.kind = Kind::paraboloid;
  quadric.lower_bound = number(1, 6);
  CHECK(error_of(quadric) == "6: 'upper_bound' of a paraboloid must be greater than 'lower_bound'");
  quadric.lower_bound = number(-3, 6);
  quadric.upper_bound = number(-2, 8);
  CHECK(error_of(quadric) == "8: 'upper_bound' of a paraboloid must be greater than 0");
  quadric.upper_bound = {};
  quadric.b = number(0, 2);
  CHECK(error_of(quadric) == "2: 'B' of a paraboloid must not be 0");
}

TEST_CASE("an object without an end is never called far away") {
  Describe d;
  const auto plane = d.element(primitive(parser::Plane{}));
  d.top(parser::Item(d.element(parser::Translate{{1e15, 0, 1e15}}, {plane})));
  const Built built = build(d);
  CHECK(built.diagnostics.all().empty());
  CHECK(built.scene.objects.at(0).bounds.unbounded());
}

TEST_CASE(
    "a map has a place on a curved surface where it is a bare string, in other dialects, and on new shapes") {
  const TemporaryFolder folder;
  write_image(folder / "map.png", Image{2, 1, {51, 102, 204, 255, 255, 255}});
  const auto keeps_map = [&](PrimitiveShape shape, bool bare, parser::Dialect dialect) {
    parser::MaterialAssignment map = is_map(Parameter::diffuse, "map.png");
    map.value = parser::MapFile{"map.png", bare};
    Describe d;
    d.scene.dialect = dialect;
    d.top(primitive(std::move(shape), {block({map})}));
    const Built built = build(d, folder.path().string());
    REQUIRE_FALSE(built.diagnostics.has_errors());
    return built.scene.materials[built.scene.objects.at(0).material].has_maps();
  };
  using parser::Dialect;
  for (const PrimitiveShape& shape : {PrimitiveShape(parser::Sphere{}), PrimitiveShape(parser::Cylinder{}),
                                      PrimitiveShape(parser::Cone{})}) {
    CHECK_FALSE(keeps_map(shape, false, Dialect::utexas));
    CHECK(keeps_map(shape, true, Dialect::utexas));
    CHECK(keeps_map(shape, false, Dialect::hkust));
    CHECK(keeps_map(shape, false, Dialect::uw));
  }
  for (const PrimitiveShape& shape : {PrimitiveShape(parser::Plane{}), PrimitiveShape(parser::Torus{}),
                                      PrimitiveShape(parser::Quadric{})}) {
    CHECK(keeps_map(shape, false, Dialect::utexas));
  }
}
