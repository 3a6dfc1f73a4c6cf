// Numbers: what is one, and its exact value.
#include "parser/number.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "parser/list_reader.hpp"

using namespace trace::parser;

namespace {

NumberText read(const std::string& text) {
  static std::string padded;
  padded = text + std::string(text_padding, '\0');
  return read_number(padded.data(), padded.data() + text.size());
}

// The value of a number that stands in a list of points, where the fast reader takes it.
double in_list(const std::string& text) {
  std::string list = "((";
  list.append(text).append(",0,0))");
  const Source source = Source::from_text("list", list);
  Diagnostics diagnostics;
  std::vector<double> numbers;
  REQUIRE(read_tuples(3, source, 1, numbers, diagnostics).need == ListNeed::nothing);
  REQUIRE_FALSE(diagnostics.has_errors());
  return numbers.at(0);
}

}  // namespace

TEST_CASE("numbers may be written in every legal way") {
  const std::string text =
      GENERATE("1", "-1", "+1", ".5", "-.5", "5.", "0012", "1e5", "1E5", "1e+5", "1e-5", "5.e1", ".5E-1",
               "-0", "123456789012345678901234567890", "0.1234567890123456789012");
  const NumberText number = read(text);
  CHECK(number.state == NumberState::good);
  CHECK(number.value == std::strtod(text.c_str(), nullptr));
}

TEST_CASE("a malformed number takes in the whole run it stands in") {
  const std::string text = GENERATE("1-2", "1.2.3", "-", ".", "--1", "1e", "1-e", "+", "-.", "0x10", "1f",
                                    "1e5.5", "1+2", "1e+", "1_000", "1emissive", "..", "1.-");
  const NumberText number = read(text + ",");
  CHECK(number.state == NumberState::malformed);
  CHECK(number.value == 0);
  CHECK(*number.end == ',');
}

TEST_CASE("a reserved word may follow a number without a blank") {
  const NumberText number = read("1shininess=2");
  CHECK(number.state == NumberState::good);
  CHECK(std::string(number.end) == "shininess=2");
}

TEST_CASE("what is too large is out of range, what is too small is zero or a denormal") {
  CHECK(read("1e999").state == NumberState::out_of_range);
  CHECK(read("-1e309").state == NumberState::out_of_range);
  CHECK(read(std::string(400, '9')).state == NumberState::out_of_range);
  CHECK(read("1e99999999999999999999").state == NumberState::out_of_range);
  CHECK(read("0e999").value == 0);
  CHECK(read("0e999").state == NumberState::good);
  CHECK(read("1e-999").value == 0);
  CHECK(read("1e-999").state == NumberState::good);
  CHECK(std::signbit(read("-1e-999").value));
  CHECK(read(std::string("0.") + std::string(400, '0') + "1").state == NumberState::good);
  CHECK(read(std::string("0.") + std::string(400, '0') + "1e401").value == 1);
  CHECK(read("5e-324").value == 5e-324);
  CHECK(read("1e-310").value == 1e-310);
  CHECK(read("2.2250738585072011e-308").value == 2.2250738585072011e-308);
  CHECK(read("1.7976931348623157e308").value == 1.7976931348623157e308);
}

TEST_CASE("the values of lists are the nearest doubles") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::string text(random() % 2, '-');
    const auto digits = 1 + random() % 22;
    const auto point = random() % (digits + 1);
    for (std::uint64_t k = 0; k < digits; ++k) {
      if (k == point) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    if (random() % 4 == 0) text.append("e").append(std::to_string(static_cast<int>(random() % 560) - 280));
    const double value = in_list(text);
    INFO(text);
    REQUIRE(value == std::strtod(text.c_str(), nullptr));
  }
}

TEST_CASE("the fast reader is exact at the edge of 2^53 and of 19 digits") {
  const std::string text =
      GENERATE("9007199254740992", "9007199254740993", "9007199254740994.5", "9.007199254740993",
               "0.9007199254740993", "9999999999999999999", "18446744073709551616", "0.0000000000000000001",
               "00000000000000000000001.5", "1234567890123456789");
  CHECK(in_list(text) == std::strtod(text.c_str(), nullptr));
}
