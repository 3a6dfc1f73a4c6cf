// No text, however broken, large or deep, does the parser any harm.
#include <catch2/catch.hpp>
#include <chrono>

#include "helpers.hpp"

using namespace trace::parser;
using namespace trace::parser::test;

namespace {

const std::string sample =
    "SBT-raytracer 1.0 // first\n"
    "camera { position=(0,0,-4); viewdir=(0,0,1); updir=(0,1,0); aspectratio=1; }\n"
    "point_light { position=(1,2,3); color=(1,1,1) constant_attenuation_coeff=.5; }\n"
    "material={ name \"red\"; diffuse=(1,0,0); shininess=map(\"t.bmp\"); }\n"
    "{ translate(1,-2e-3,3, rotate(0,0,1,.5, sphere { material=red; name=a; })); scale(2,box{}) }\n"
    "trimesh { points=((0,0,0),(1,0,0),(0,1,0)); faces=((0,1,2)); /* c */ gennormals;\n"
    "  materials=({diffuse=(1,0,0)},red,{}); }\n"
    "transform((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1), cone { capped=true; height=2; })\n";

// Parses, and checks what holds for every text: each error has a text, and a place in the file.
std::size_t errors_of(const std::string& text) {
  const Source source = Source::from_text("scene.ray", text);
  Diagnostics diagnostics;
  parse(source, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    REQUIRE_FALSE(diagnostic.text.empty());
    REQUIRE(diagnostic.span.begin <= diagnostic.span.end);
    REQUIRE(diagnostic.span.end <= text.size());
  }
  if (diagnostics.has_errors()) REQUIRE_FALSE(render(source, diagnostics).empty());
  return diagnostics.error_count();
}

std::string repeated(std::size_t count, const std::string& text) {
  std::string result;
  result.reserve(count * text.size());
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

double seconds_for(const std::string& text) {
  const auto begin = std::chrono::steady_clock::now();
  errors_of(text);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("every beginning of a scene is parsed without harm, and the whole without error") {
  for (std::size_t length = 0; length < sample.size(); ++length) errors_of(sample.substr(0, length));
  CHECK(errors_of(sample) == 0);
}

TEST_CASE("a scene cut in the middle of a block is an error") {
  CHECK(errors_of(sample.substr(0, sample.find("viewdir"))) == 1);
  CHECK(errors_of(sample.substr(0, sample.find("gennormals"))) == 1);
}

TEST_CASE("every scene with one byte changed or lost is parsed without harm") {
  const std::string bytes("\0 \n\"(){},=;/*#-.e1x\x80\xFF", 22);
  for (std::size_t at = 0; at < sample.size(); ++at) {
    std::string text = sample;
    for (const char byte : bytes) {
      text[at] = byte;
      errors_of(text);
    }
    errors_of(sample.substr(0, at) + sample.substr(at + 1));
  }
}

TEST_CASE("one bracket, comma, equals sign or semicolon lost is one error") {
  std::size_t worst = 0;
  for (std::size_t at = sample.find('{'); at < sample.size(); ++at) {
    if (std::string("(){},=;").find(sample[at]) == std::string::npos) continue;
    worst = std::max(worst, errors_of(sample.substr(0, at) + " " + sample.substr(at + 1)));
  }
  CHECK(worst == 1);
}

TEST_CASE("objects nest 100 000 deep, and one deeper is a clear error") {
  const std::string open = GENERATE("{", "translate(1,2,3,", "scale(2,");
  const std::string close = open == "{" ? "}" : ")";
  const auto nested = [&](std::size_t depth) {
    return header + repeated(depth, open) + "sphere{}" + repeated(depth, close);
  };
  CHECK(errors_of(nested(max_nesting)) == 0);
  const std::string found = messages_of_file(nested(max_nesting + 1));
  CHECK(found.substr(found.find("error")) == "error: objects are nested more than 100000 deep\n");
}

TEST_CASE("an error at the bottom of deep nesting is found there, and only once") {
  const std::string text = repeated(50000, "{translate(1,2,3,") + "sphere{x=1;}" + repeated(50000, ")}");
  CHECK(messages(text) ==
        "2:850008: error: unknown attribute 'x' in a sphere\n"
        "2:850008: note: a sphere takes material and name\n");
}

TEST_CASE("the time for hostile texts grows no faster than the texts") {
  const std::string unit =
      GENERATE("foo ", "@ ", "}", "(", "{(", "sphere{foo=1;}", "sphere{name=\"\n",
               "trimesh{points=((0,0,0,0));", "/**/", "sphere{{", "translate(1,2,3,sphere{} ",
               "material={name x", "points=(", "a", "1", "\"", "1e", "//", "/*");
  const double small = seconds_for(header + repeated(20000, unit));
  const double large = seconds_for(header + repeated(200000, unit));
  INFO(unit);
  CHECK(large < 60 * small + 0.5);  // 10 times the text; a square would take 100 times
}
