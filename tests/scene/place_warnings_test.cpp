// What is said of places where nothing can be drawn, or nothing precisely.
#include <catch2/catch.hpp>

#include "parser/parse.hpp"
#include "scene/build.hpp"

using namespace trace;

namespace {

// All that is said about a scene with these elements, or the first lines of it without the echoed source.
std::string said(const std::string& elements) {
  const parser::Source source = parser::Source::from_text("s.ray", "SBT-raytracer 1.0\n" + elements);
  parser::Diagnostics diagnostics;
  parser::Scene description = parser::parse(source, diagnostics);
  FileImages images;
  build_scene(std::move(description), source, images, diagnostics);
  return parser::render(source, diagnostics);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::size_t warnings(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(": warning: "); at != std::string::npos; ++count) {
    at = text.find(": warning: ", at + 1);
  }
  return count;
}

}  // namespace

TEST_CASE("a transform that flattens all inside it is said, with its place and reason") {
  CHECK(said("sphere { }\ntranslate(1,2,3, scale(1,1,0, sphere { }))\n") ==
        "s.ray:3:18: warning: nothing inside this scale is drawn: its factor for z is 0\n"
        "translate(1,2,3, scale(1,1,0, sphere { }))\n"
        "                 ^~~~~\n");
  CHECK(first_line(said("scale(0,1,0, sphere { })")) ==
        "s.ray:2:1: warning: nothing inside this scale is drawn: its factors for x and z are 0");
  CHECK(first_line(said("scale(0, sphere { })")) ==
        "s.ray:2:1: warning: nothing inside this scale is drawn: it scales by 0");
  CHECK(first_line(said("rotate(0,0,0,1, box { })")) ==
        "s.ray:2:1: warning: nothing inside this rotate is drawn: the axis (0, 0, 0) is no direction");
  CHECK(first_line(said("transform((1,2,3,0),(4,5,6,0),(7,8,9,0),(0,0,0,1), box { })")) ==
        "s.ray:2:1: warning: nothing inside this transform is drawn: its matrix has no inverse");
}

TEST_CASE("transforms that only together leave the range of doubles are said where they do") {
  CHECK(first_line(said("scale(1e-200, scale(1e-200, scale(1e200, sphere { })))")) ==
        "s.ray:2:15: warning: nothing inside this scale is drawn: with the transforms around it, it makes "
        "things too small for double precision");
  CHECK(
      first_line(said("scale(1e200, translate(1e200,0,0, sphere { }))")) ==
      "s.ray:2:14: warning: nothing inside this translate is drawn: with the transforms around it, it makes "
      "numbers too large for double precision");
}

TEST_CASE("a singular transform is said once, the outermost, and only with an object inside") {
  const std::string text = said(
      "scale(0, { sphere { } box { } scale(0, { sphere { } { cone { } } }) })\n"
      "scale(0, { })\n");
  CHECK(warnings(text) == 1);
  CHECK_THAT(text, Catch::StartsWith("s.ray:2:1: warning: "));
}

TEST_CASE("however many singular transforms there are, few are said and the rest is counted") {
  std::string scene;
  for (int i = 0; i < 100; ++i) scene += "scale(0, sphere { })\n";
  const std::string text = said(scene);
  CHECK(warnings(text) == 6);
  CHECK_THAT(text,
             Catch::Contains("s.ray:6:1: warning: nothing inside this scale is drawn: it scales by 0\n"));
  CHECK_THAT(text, Catch::Contains("s.ray:7:1: warning: nothing inside 95 more transforms is drawn\n"));
}

TEST_CASE("six warnings of a kind are all given") {
  std::string scene;
  for (int i = 0; i < 6; ++i) scene += "scale(0, sphere { })\n";
  CHECK_THAT(said(scene),
             Catch::Contains("s.ray:7:1: warning: nothing inside this scale is drawn: it scales by 0\n"));
}

TEST_CASE("an object that doubles cannot resolve where it lies is said") {
  CHECK(said("translate(1e9,0,0, scale(0.0005, sphere { }))\n") ==
        "s.ray:2:34: warning: this sphere is 0.001 across and 1e+09 from the origin, where double precision "
        "has steps of 1.2e-07\n"
        "translate(1e9,0,0, scale(0.0005, sphere { }))\n"
        "                                 ^~~~~~\n");
  // Even where its bounds have become a point.
  CHECK(warnings(said("translate(1e9,0,0, scale(1e-9, box { }))")) == 1);
  CHECK(warnings(said("trimesh { points=((1e9,0,0),(1000000000.001,0,0),(1e9,0.001,0)); "
                      "faces=((0,1,2)); }")) == 1);
}

TEST_CASE("steps below a millionth of the size are fine, and above are said") {
  // 2^33 has steps of 2^-19 above it; a box of 2 is there from 2^33 to 2^33 + 2.
  CHECK(said("translate(8589934593,0,0, scale(2, box { }))").empty());
  CHECK(warnings(said("translate(8589934593,0,0, scale(1.9, box { }))")) == 1);
  CHECK(said("translate(1e6,0,0, scale(0.001, sphere { }))").empty());
  CHECK(said("scale(1e-30, sphere { })").empty());
  CHECK(said("scale(1e30, sphere { })").empty());
}

TEST_CASE("however many objects lie far out, few are said and the rest is counted") {
  std::string scene;
  for (int i = 0; i < 1000; ++i) scene += "translate(1e9,0,0, scale(1e-4, cone { }))\n";
  const std::string text = said(scene);
  CHECK(warnings(text) == 6);
  CHECK_THAT(text, Catch::Contains("s.ray:7:32: warning: 995 more objects are as far out for their size\n"));
}
