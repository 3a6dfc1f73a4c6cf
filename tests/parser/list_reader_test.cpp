// Lists of meshes are read in one piece; nothing else may tell that from reading them token by token.
#include "parser/list_reader.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <random>

#include "helpers.hpp"
#include "parser/scanner.hpp"

using namespace trace::parser;
using namespace trace::parser::test;

namespace {

// The numbers of a text, token by token.
std::vector<double> numbers_by_token(const std::string& text) {
  const Source source = Source::from_text("list", text);
  Diagnostics diagnostics;
  Scanner scanner(source, diagnostics);
  std::vector<double> result;
  for (Token token = scanner.next(); token.kind != T::END; token = scanner.next()) {
    if (token.kind == T::NUMBER) result.push_back(token.number);
  }
  REQUIRE_FALSE(diagnostics.has_errors());
  return result;
}

std::string random_blank(std::mt19937_64& random) {
  constexpr std::array<const char*, 10> blanks{
      "", "", "", " ", "\n", "\r\n", "\t\f\v", "/* 7 , ) **/", "// 8 )\n", "\r"};
  return blanks[random() % blanks.size()];
}

std::string random_number(std::mt19937_64& random) {
  constexpr std::array<const char*, 12> numbers{"0",  "-1.5",     ".25",    "1e-3",
                                                "+4", "7.",       "1E2",    "-0",
                                                "12", "3.141592", "1e-400", "0.30000000000000004441"};
  return numbers[random() % numbers.size()];
}

}  // namespace

TEST_CASE("a list read in one piece gives the numbers that the scanner gives") {
  std::mt19937_64 random(2);
  for (int round = 0; round < 300; ++round) {
    std::string list = "(";
    list += random_blank(random);
    const auto entries = random() % 20;
    for (std::uint64_t i = 0; i < entries; ++i) {
      list += i > 0 ? "," : "";
      list += random_blank(random);
      list += "(";
      for (int k = 0; k < 3; ++k) {
        list += k > 0 ? "," : "";
        list += random_blank(random);
        list += random_number(random);
        list += random_blank(random);
      }
      list += ")";
      list += random_blank(random);
    }
    list += ")";
    const Source source = Source::from_text("list", list + ";");
    Diagnostics diagnostics;
    std::vector<double> numbers;
    const ListStop stop = read_tuples(3, source, 1, numbers, diagnostics);
    INFO(list);
    REQUIRE(stop.need == ListNeed::nothing);
    REQUIRE(stop.offset == list.size());
    REQUIRE(numbers == numbers_by_token(list));
  }
}

TEST_CASE("the reading goes on right behind a list") {
  const Scene scene =
      scene_of(header + "trimesh{points=((0,0,0),(1,0,0),(0,1,0));faces=((0,1,2));name=\"a\";}box{}");
  CHECK(scene.items.size() == 2);
  CHECK(scene.meshes.at(0).corners == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(std::get<Primitive>(scene.elements.at(0).what).name->value == "a");
}

TEST_CASE("whole indices may be written like any number") {
  const Scene scene =
      scene_of(header + "trimesh{points=((0,0,0),(1,0,0),(0,1,0));faces=((2,1.0,0e7),(+1,2e0,-0));}");
  CHECK(scene.meshes.at(0).corners == std::vector<std::uint32_t>{2, 1, 0, 1, 2, 0});
}

TEST_CASE("faces of three corners need no sizes, others keep theirs") {
  const std::string points = "points=((0,0,0),(1,0,0),(0,1,0),(1,1,0));";
  CHECK(scene_of(header + "trimesh{" + points + "faces=((0,1,2),(1,2,3));}").meshes.at(0).face_sizes.empty());
  const Scene mixed = scene_of(header + "trimesh{" + points + "faces=((0,1,2));faces=((0,1,3,2),(1,2,3));}");
  CHECK(mixed.meshes.at(0).face_sizes == std::vector<std::uint32_t>{3, 4, 3});
  CHECK(mixed.meshes.at(0).corners.size() == 10);
}

TEST_CASE("faces may come before the points, and lists add up") {
  const Scene scene =
      scene_of(header + "polymesh{faces=((0,1,2));points=((0,0,0),(1,0,0));points=((0,1,0));}");
  const Mesh& mesh = scene.meshes.at(0);
  CHECK(mesh.points == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  REQUIRE(mesh.point_lists.size() == 2);
  CHECK(mesh.point_lists[1].first == 6);
  CHECK(mesh.point_lists[1].count == 3);
}

TEST_CASE("the place of one number of a list can be found again") {
  const std::string text = "( /* 1 */ (10, 20 ,30), // 5\n (4e1,50,+60))";
  const Source source = Source::from_text("list", text);
  const Span list{0, static_cast<std::uint32_t>(text.size())};
  for (std::uint64_t k = 0; k < 6; ++k) {
    const Span place = number_span(source, list, k);
    const std::string written = text.substr(place.begin, place.end - place.begin);
    CHECK(std::stod(written) == 10.0 * static_cast<double>(k + 1));
  }
}

TEST_CASE("an error deep in a long list is found at its own place") {
  std::string list;
  for (int i = 0; i < 10000; ++i) list += fmt::format("({},{}.5,-{}e-1),\n", i, i, i);
  CHECK(messages("trimesh{points=(\n" + list + "(1,2,x),(1,2,3));}") ==
        "10003:6: error: expected a number, found 'x'\n");
  CHECK(messages("trimesh{points=(\n" + list + "(1,2-2,3),(1,2,3));}") ==
        "10003:4: error: malformed number '2-2'\n");
  CHECK(messages("trimesh{points=(\n" + list + "(1,2,3);}") ==
        "10003:8: error: expected ',' or ')' after a point, found ';'\n");
}

TEST_CASE("a long list and a list of any size keep every number") {
  const int count = GENERATE(0, 1, 15, 16, 17, 1000, 33333);
  std::string points, faces;
  for (int i = 0; i < count; ++i) {
    points += fmt::format("{}({},{},{})", i > 0 ? ", " : "", i, 0.5 * i, -i);
    faces += fmt::format("{}({},{},{})", i > 0 ? "," : "", i, 0, i / 2);
  }
  const Scene scene = scene_of(header + "trimesh{points=(" + points + ");faces=(" + faces + ");}");
  const Mesh& mesh = scene.meshes.at(0);
  REQUIRE(mesh.points.size() == 3 * static_cast<std::size_t>(count));
  REQUIRE(mesh.corners.size() == 3 * static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    REQUIRE(mesh.points[3 * i + 1] == 0.5 * static_cast<double>(i));
    REQUIRE(mesh.corners[3 * i] == i);
  }
}
