// JSON values know where they stand, and nothing that a file says goes unnoticed.
#include "loading/json_file.hpp"

#include <catch2/catch.hpp>

#include "loading/json_keys.hpp"

namespace trace::test {
namespace {

struct Parsed {
  parser::Source source;
  parser::Diagnostics diagnostics;
  std::optional<JsonValue> root;

  explicit Parsed(std::string text)
      : source(parser::Source::from_text("t.json", std::move(text))), root(parse_json(source, diagnostics)) {}

  std::string at(parser::Span span) const {
    return std::string(source.text().substr(span.begin, span.end - span.begin));
  }
  std::string messages() const { return parser::render(source, diagnostics); }
};

}  // namespace

TEST_CASE("every JSON value has the place of its own text") {
  const Parsed parsed(R"( {"a" : [1,-2.5e3 , true], "b":{"c": null,"d":"x\"y"}, "e":7} )");
  REQUIRE(parsed.root);
  const auto& object = *parsed.root->get<JsonValue::Object>();
  REQUIRE(object.size() == 3);
  CHECK(parsed.at(parsed.root->span) == R"({"a" : [1,-2.5e3 , true], "b":{"c": null,"d":"x\"y"}, "e":7})");
  CHECK(parsed.at(object[0].name_span) == "\"a\"");
  CHECK(parsed.at(object[0].value.span) == "[1,-2.5e3 , true]");
  const auto& list = *object[0].value.get<JsonValue::Array>();
  REQUIRE(list.size() == 3);
  CHECK(parsed.at(list[0].span) == "1");
  CHECK(parsed.at(list[1].span) == "-2.5e3");
  CHECK(*list[1].get<double>() == -2500);
  CHECK(parsed.at(list[2].span) == "true");
  const auto& inner = *object[1].value.get<JsonValue::Object>();
  CHECK(parsed.at(inner[0].value.span) == "null");
  CHECK(parsed.at(inner[1].name_span) == "\"d\"");
  CHECK(parsed.at(inner[1].value.span) == R"("x\"y")");
  CHECK(*inner[1].value.get<std::string>() == "x\"y");
  CHECK(parsed.at(object[2].value.span) == "7");
}

TEST_CASE("JSON nested too deeply is an error at the bracket, not a crash") {
  const std::string deep(max_json_depth, '[');
  CHECK(Parsed(deep + std::string(max_json_depth, ']')).root);
  const Parsed parsed(deep + "[" + std::string(max_json_depth + 1, ']'));
  CHECK(!parsed.root);
  CHECK_THAT(parsed.messages(),
             Catch::StartsWith("t.json:1:65: error: lists and objects are nested too deeply\n"));
  CHECK(!Parsed(std::string(1 << 20, '[')).root);
}

TEST_CASE("text behind a JSON value is an error") {
  const Parsed parsed("{} 5");
  CHECK(!parsed.root);
  CHECK_THAT(parsed.messages(), Catch::StartsWith("t.json:1:4: error: this is not valid JSON\n"));
}

TEST_CASE("keys take their values, and what does not fit is told with its place") {
  const Parsed parsed(R"({"name": "x", "share": 2, "none": null, "shaer": 1, "on": "yes"})");
  REQUIRE(parsed.root);
  std::optional<std::string> name;
  std::optional<double> share, none = 3;
  std::optional<bool> on;
  parser::Diagnostics diagnostics;
  take_members(*parsed.root->get<JsonValue::Object>(),
               {{"name", text_key(&name)},
                {"share", number_key(&share, 0, 1)},
                {"none", number_or_null_key(&none)},
                {"on", boolean_key(&on)}},
               "key", false, diagnostics);
  CHECK(name == "x");
  CHECK(!share);
  CHECK(!none);
  const std::string messages = parser::render(parsed.source, diagnostics);
  CHECK_THAT(messages, Catch::Contains("t.json:1:24: error: 'share' takes a number from 0 to 1\n"));
  CHECK_THAT(messages, Catch::Contains("t.json:1:41: error: unknown key 'shaer'\n"));
  CHECK_THAT(messages, Catch::Contains("note: did you mean 'share'?\n"));
  CHECK_THAT(messages, Catch::Contains("t.json:1:59: error: 'on' takes true or false\n"));
}

}  // namespace trace::test
