// Torus knots and height fields.
#include <map>

#include "scene/height_field.hpp"
#include "scene/torus_knot.hpp"
#include "tests/image/picture_files.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_describe.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Whether each edge between two places has as many faces one way as the other.
bool is_closed(const Mesh& mesh) {
  std::map<std::array<double, 6>, int> edges;
  for (const FaceCorners& f : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 &a = mesh.points[f[i]], &b = mesh.points[f[(i + 1) % 3]];
      ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
      --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
    }
  }
  for (const auto& [edge, count] : edges) {
    if (count != 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a torus knot is closed, faces outward, and has its tube's radius around its strands") {
  const double q = GENERATE(3.5, 2.0, 0.0, -1.5, 0.7, 1.3);
  INFO("q " << q);
  const TorusKnot knot{1, 0.15, 0.4, q};
  const Mesh mesh = make_torus_knot(knot);
  CHECK(is_closed(mesh));
  REQUIRE(mesh.normals.size() == mesh.points.size());
  double most = 0;
  for (const Vec3& p : mesh.points) {
    // In the plane through the axis, from the middle of the nearer strand.
    const double a = std::atan2(p.x, p.z), r = std::hypot(p.x, p.z);
    double distance = 1e9;
    for (const double s : {1.0, -1.0}) {
      distance =
          std::min(distance, std::hypot(r - 1 - s * 0.4 * std::sin(q * a), p.y - s * 0.4 * std::cos(q * a)));
    }
    most = std::max(most, std::abs(distance - 0.15));
  }
  // The disks that close ends have their middles in them.
  CHECK((most < 1e-9 || (2 * q != std::round(2 * q) && most < 0.16)));
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 normal = face_normal(mesh.triangle(f));
    for (const std::uint32_t corner : mesh.faces[f]) {
      CHECK(glm::dot(normal, glm::normalize(mesh.normals[corner])) > 0.8);
    }
  }
}

TEST_CASE("a torus knot without offset is one torus") {
  const Mesh mesh = make_torus_knot({2, 0.5, 0, 3});
  CHECK(is_closed(mesh));
  for (const Vec3& p : mesh.points) CHECK(std::hypot(std::hypot(p.x, p.z) - 2, p.y) == about(0.5));
}

TEST_CASE("a torus knot winds as often as it may, within the limit of its size") {
  const Mesh mesh = make_torus_knot({1, 0.15, 0.4, TorusKnot::most_q});
  CHECK(mesh.faces.size() <= 2 * 2 * 8192 * 48);
  for (const Vec3& p : mesh.points) CHECK(is_finite(p));
}

TEST_CASE("a torus knot without extent, or that winds too often, is an error at its number") {
  const auto errors = [](const parser::TorusKnot& knot) {
    Describe d;
    d.top(primitive(knot));
    const Built built = build(d);
    REQUIRE(built.diagnostics.error_count() == 1);
    return built.diagnostics.all()[0].text;
  };
  const parser::Span span{3, 4};
  CHECK(errors({parser::Scalar{0, span}, {}, {}, {}}) == "the radius of a torus_knot must be more than 0");
  CHECK(errors({{}, parser::Scalar{-1, span}, {}, {}}) == "the tube of a torus_knot must be more than 0");
  CHECK(errors({{}, {}, {}, parser::Scalar{1e9, span}}) ==
        "the q of a torus_knot must be from -1000 to 1000");
}

TEST_CASE("a height field has a point a texel over the unit square, right way round from above") {
  // From the top: black, white / grey 51, grey 102.
  const Texture heights(Image{2, 2, {0, 0, 0, 255, 255, 255, 51, 51, 51, 102, 102, 102}});
  const Mesh mesh = make_height_field(heights, false);
  REQUIRE(mesh.points.size() == 4);
  CHECK(mesh.points[0] == near(1, 0.2, 0));  // lower left
  CHECK(mesh.points[1] == near(0, 0.4, 0));
  CHECK(mesh.points[2] == near(1, 0, 1));
  CHECK(mesh.points[3] == near(0, 1, 1));
  CHECK(mesh.coordinates[3] == Vec2(1, 1));
  for (std::uint32_t f = 0; f < 2; ++f) CHECK(face_normal(mesh.triangle(f)).y > 0);
  CHECK_FALSE(mesh.smooth());
  CHECK(make_height_field(heights, true).normals.size() == 4);
}

TEST_CASE("a height field of a large picture stays within its grid") {
  const Texture wide(Image{5000, 2, std::vector<std::uint8_t>(30000, 7)});
  CHECK(make_height_field(wide, false).points.size() == std::size_t{most_grid_side} * 2);
  const Texture point(Image{1, 1, {255, 0, 0}});
  CHECK(make_height_field(point, false).points.size() == 4);
}

TEST_CASE(
    "a height field emits its colour map; one that is not there is a warning, missing heights an error") {
  const TemporaryFolder folder;
  write_image(folder / "h.png", Image{2, 2, std::vector<std::uint8_t>(12, 0)});
  write_image(folder / "c.png", Image{2, 1, {255, 0, 0, 0, 0, 255}});
  const auto built_of = [&](const std::string& heights, const std::string& colors) {
    Describe d;
    parser::HeightField field;
    field.height_map = parser::Name{heights, {5, 6}};
    field.color_map = parser::Name{colors, {7, 8}};
    d.top(primitive(field, {block({is(Parameter::emissive, 0, 1, 0)})}));
    return build(d, folder.path().string());
  };
  const Ray down = ray({0.25, 3, 0.5}, {0, -1, 0});
  const Built built = built_of("C:/Users/x/h.png", "C:/Users/x/c.png");
  CHECK(built.diagnostics.all().empty());
  CHECK(seen(built.scene, down) == near(0.25, 0, 0.75));
  const Built grey = built_of("h.png", "none.png");
  REQUIRE(grey.diagnostics.all().size() == 1);
  CHECK(grey.diagnostics.all()[0].text ==
        "cannot read texture 'none.png': no such file: this map is left out");
  CHECK(seen(grey.scene, down) == Rgb(0, 1, 0));
  const Built none = built_of("none.png", "c.png");
  REQUIRE(none.diagnostics.error_count() == 1);
  CHECK(none.diagnostics.all()[0].text == "cannot read height map 'none.png': no such file");
}
