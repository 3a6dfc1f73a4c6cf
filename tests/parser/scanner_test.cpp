// Tokens and their places.
#include "parser/scanner.hpp"

#include <catch2/catch.hpp>

#include "helpers.hpp"

using namespace trace::parser;
using namespace trace::parser::test;

namespace {

struct Scanned {
  std::vector<Token> tokens;
  std::string report;
};

Scanned scan(const std::string& text) {
  const Source source = Source::from_text("scene.ray", text);
  Diagnostics diagnostics;
  Scanner scanner(source, diagnostics);
  Scanned result;
  for (Token token = scanner.next(); token.kind != T::END; token = scanner.next())
    result.tokens.push_back(token);
  for (const Diagnostic& diagnostic : diagnostics.all()) result.report += diagnostic.text + "\n";
  return result;
}

std::vector<Kind> kinds(const std::string& text) {
  std::vector<Kind> result;
  const Scanned scanned = scan(text);
  CHECK(scanned.report.empty());
  for (const Token& token : scanned.tokens) result.push_back(token.kind);
  return result;
}

using Kinds = std::vector<Kind>;

}  // namespace

TEST_CASE("a token's place is exact, in bytes") {
  const Scanned scanned = scan("sphere /* \xC3\xA9 */ { name=\"\xC3\xA9\";}");
  REQUIRE(scanned.tokens.size() == 7);
  CHECK(scanned.tokens[0].span == Span{0, 6});
  CHECK(scanned.tokens[1].span == Span{16, 17});
  CHECK(scanned.tokens[4].kind == T::STRING);
  CHECK(scanned.tokens[4].span == Span{23, 27});
}

TEST_CASE("words are longest matches, hyphens and digits included") {
  CHECK(kinds("sphere-2 sphere2 sphere_ sphere Sphere _ a-") ==
        Kinds{T::WORD, T::WORD, T::WORD, T::SPHERE, T::WORD, T::WORD, T::WORD});
}

TEST_CASE("colour is color and polymesh is trimesh") {
  CHECK(kinds("colour color polymesh trimesh") == Kinds{T::COLOR, T::COLOR, T::MESH, T::MESH});
}

TEST_CASE("words, numbers and strings of any length are one token") {
  const std::size_t length = GENERATE(1u, 47u, 48u, 49u, 50u, 300u, 8191u, 8192u, 100000u);
  const std::string run(length, '1');
  const Scanned scanned =
      scan("a" + run + " " + run + "." + run + " \"" + run + "\" " + std::string(length, ' ') + "}");
  REQUIRE(scanned.tokens.size() == 4);
  CHECK(scanned.tokens[0].span == Span{0, static_cast<std::uint32_t>(length + 1)});
  CHECK(scanned.tokens[1].kind == T::NUMBER);
  CHECK(scanned.tokens[1].span.end - scanned.tokens[1].span.begin == 2 * length + 1);
  CHECK(scanned.tokens[2].span.end - scanned.tokens[2].span.begin == length + 2);
  CHECK(scanned.tokens[3].kind == T::CLOSE_BRACE);
}

TEST_CASE("comments separate like blanks and end as they should") {
  CHECK(kinds("1/**/2/***/3/* **/4/* * */5//6\n7//8\r9//10\r\n11// end") ==
        Kinds{T::NUMBER, T::NUMBER, T::NUMBER, T::NUMBER, T::NUMBER, T::NUMBER, T::NUMBER, T::NUMBER});
  CHECK(kinds("sphere // x") == Kinds{T::SPHERE});
}

TEST_CASE("form feed and vertical tab are blanks, and a byte-order mark is none of the text") {
  CHECK(kinds("\xEF\xBB\xBF sphere\f\v\r\tbox") == Kinds{T::SPHERE, T::BOX});
  CHECK(scan("sphere \xEF\xBB\xBF").report == "unexpected character U+FEFF\n");
}

TEST_CASE("a string is a name even if it spells a keyword, and holds any byte of its line") {
  CHECK(kinds("\"sphere\" \"\" \"// no comment\" \"\xFF\"") ==
        Kinds{T::STRING, T::STRING, T::STRING, T::STRING});
}

TEST_CASE("an unexpected character is named so that it can be seen") {
  CHECK(scan("#").report == "unexpected character '#'\n");
  CHECK(scan(std::string(1, '\0')).report == "unexpected character '\\x00'\n");
  CHECK(scan("\x1A").report == "unexpected character '\\x1A'\n");
  CHECK(scan("\xC2\xA0").report == "unexpected character U+00A0\n");
  CHECK(scan("\xC2").report == "unexpected character '\\xC2'\n");
  CHECK(scan("\xF0\x9F\x98\x80").report == "unexpected character U+1F600\n");
}

TEST_CASE("a run of unexpected characters is one error") {
  const Scanned scanned = scan("@@\xFF\xFE$ sphere");
  CHECK(scanned.report == "unexpected character '@'\n");
  REQUIRE(scanned.tokens.size() == 1);
  CHECK(scanned.tokens[0].kind == T::SPHERE);
  CHECK(scanned.tokens[0].after_error);
}

TEST_CASE("a number keeps its value and its place") {
  const Scanned scanned = scan("index=1shininess=-2.5e1}");
  REQUIRE(scanned.tokens.size() == 7);
  CHECK(scanned.tokens[2].number == 1);
  CHECK(scanned.tokens[2].span == Span{6, 7});
  CHECK(scanned.tokens[3].kind == T::SHININESS);
  CHECK(scanned.tokens[5].number == -25);
}

TEST_CASE("the scanner can go back and on to any place") {
  const Source source = Source::from_text("scene.ray", "sphere box cone");
  Diagnostics diagnostics;
  Scanner scanner(source, diagnostics);
  CHECK(scanner.next().kind == T::SPHERE);
  scanner.seek(11);
  CHECK(scanner.next().kind == T::CONE);
  CHECK(scanner.next().kind == T::END);
  scanner.seek(7);
  CHECK(scanner.next().span == Span{7, 10});
  CHECK(scanner.next().kind == T::CONE);
  CHECK(scanner.next().kind == T::END);
  CHECK(scanner.next().kind == T::END);
}
