// How messages look.
#include <catch2/catch.hpp>

#include "helpers.hpp"

using namespace trace::parser;
using namespace trace::parser::test;

namespace {

// The rendered error about bytes [begin, end) of a text.
std::string shown(const std::string& text, std::uint32_t begin, std::uint32_t end) {
  const Source source = Source::from_text("t", text);
  Diagnostics diagnostics;
  diagnostics.error({begin, end}, "here");
  return render(source, diagnostics);
}

}  // namespace

TEST_CASE("a message has its place, its line, its marks, a suggestion and notes") {
  CHECK(
      report("SBT-raytracer 1.0\nsphere {\n    material={\n    difuse=(1,0,0);\n    }\n}\n") ==
      "scene.ray:4:5: error: unknown attribute 'difuse' in a material\n"
      "    difuse=(1,0,0);\n"
      "    ^~~~~~\n"
      "scene.ray:4:5: note: did you mean 'diffuse'?\n"
      "scene.ray:4:5: note: a material takes emissive, ambient, diffuse, specular, reflective, transmissive, "
      "shininess, index, name, absorb, glossiness, specular_model, bump and normal\n");
}

TEST_CASE("a note about another place shows that place") {
  CHECK(report("SBT-raytracer 1.0\npoint_light {\n  position=(0,0,0);\n  color=(1,1,1);\n  "
               "position=(1,0,0);\n}\n") ==
        "scene.ray:5:3: error: 'position' is given twice in this point_light\n"
        "  position=(1,0,0);\n"
        "  ^~~~~~~~\n"
        "scene.ray:3:3: note: first given here\n"
        "  position=(0,0,0);\n"
        "  ^~~~~~~~\n");
}

TEST_CASE("marks stand under what they mark, tabs or not") {
  CHECK(shown("\ta\tbc d", 3, 5) == "t:1:4: error: here\n    a   bc d\n        ^~\n");
}

TEST_CASE("characters beyond ASCII take one column") {
  CHECK(shown("\xC3\xA9\xC3\xA9 bc", 5, 7) == "t:1:6: error: here\n\xC3\xA9\xC3\xA9 bc\n   ^~\n");
}

TEST_CASE("control characters and broken UTF-8 are spelled out") {
  CHECK(shown("\x1B[2J\xFF x", 6, 7) == "t:1:7: error: here\n\\x1B[2J\\xFF x\n            ^\n");
  CHECK(shown("\xE2\x80\xAE x", 4, 5) == "t:1:5: error: here\n<U+202E> x\n         ^\n");
  CHECK(shown("\xC2\x9B x", 3, 4) == "t:1:4: error: here\n<U+009B> x\n         ^\n");
}

TEST_CASE("a long line is cut around the place") {
  const std::string line = std::string(200, 'a') + "XY" + std::string(200, 'b');
  CHECK(shown(line, 200, 202) == "t:1:201: error: here\n..." + std::string(60, 'a') + "XY" +
                                     std::string(35, 'b') + "...\n" + std::string(63, ' ') + "^~\n");
  CHECK(shown(line, 0, 1000) ==
        "t:1:1: error: here\n" + std::string(100, 'a') + "...\n^" + std::string(99, '~') + "\n");
}

TEST_CASE("a place at the end of the line or of the text has a mark") {
  CHECK(shown("ab\ncd", 2, 2) == "t:1:3: error: here\nab\n  ^\n");
  CHECK(shown("ab\ncd", 5, 5) == "t:2:3: error: here\ncd\n  ^\n");
  CHECK(shown("", 0, 0) == "t:1:1: error: here\n\n^\n");
}

TEST_CASE("what goes over several lines is marked on its first") {
  CHECK(shown("ab cd\nef", 3, 8) == "t:1:4: error: here\nab cd\n   ^~\n");
}

TEST_CASE("only the first errors are shown, all are counted") {
  const Source source = Source::from_text("t", "a");
  Diagnostics diagnostics;
  for (int i = 0; i < 30; ++i) diagnostics.error({0, 1}, "e").notes.push_back({{0, 1}, "n"});
  CHECK(diagnostics.error_count() == 30);
  CHECK(diagnostics.all().size() == Diagnostics::limit);
  const std::string text = render(source, diagnostics);
  CHECK(text.substr(text.rfind("t: ")) == "t: 30 errors in all; the first 20 are shown\n");
}

TEST_CASE("warnings are no errors") {
  Diagnostics diagnostics;
  diagnostics.warning({0, 1}, "odd");
  CHECK_FALSE(diagnostics.has_errors());
  CHECK(render(Source::from_text("t", "a"), diagnostics) == "t:1:1: warning: odd\na\n^\n");
}

TEST_CASE("a slip finds the word that was meant, a different word finds none") {
  const std::vector<std::string_view> words{"sphere", "square", "box", "color"};
  CHECK(closest("spere", words) == "sphere");
  CHECK(closest("Sphere", words) == "sphere");
  CHECK(closest("SPHERE", words) == "sphere");
  CHECK(closest("sqaure", words) == "square");
  CHECK(closest("colr", words) == "color");
  CHECK(closest("torus", words).empty());
  CHECK(closest("a", words).empty());
  CHECK(closest("", words).empty());
  CHECK(closest(std::string(100000, 'a'), words).empty());
}
