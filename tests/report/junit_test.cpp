// JUnit's XML as a parser of XML sees it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "report/diff_junit.hpp"
#include "report/junit.hpp"
#include "tests/report/sample_report.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

constexpr const char* junit_to_json = R"(
import json, sys
import xml.etree.ElementTree as tree
def shown(node):
    return {"tag": node.tag, "is": node.attrib, "text": (node.text or "").strip(), "in": [shown(n) for n in node]}
print(json.dumps(shown(tree.fromstring(sys.stdin.buffer.read()))))
)";

// The root element: its tag, attributes ("is"), text and children ("in").
nlohmann::json parsed(const std::string& xml) {
  const PythonResult result = run_python(junit_to_json, {}, xml);
  INFO(result.output);
  REQUIRE(result.status == 0);
  return nlohmann::json::parse(result.output);
}

}  // namespace

TEST_CASE("JUnit's XML has a case a pair, failures for what differs and errors for what is not there") {
  const nlohmann::json root = parsed(diff_junit(sample_report()));
  CHECK(root["tag"] == "testsuites");
  REQUIRE(root["in"].size() == 1);
  const nlohmann::json& suite = root["in"][0];
  CHECK(suite["tag"] == "testsuite");
  CHECK(suite["is"] ==
        nlohmann::json(
            {{"name", "trace diff"}, {"tests", "4"}, {"failures", "1"}, {"errors", "2"}, {"time", "0.000"}}));
  REQUIRE(suite["in"].size() == 4);
  const nlohmann::json& beyond = suite["in"][0];
  CHECK(beyond["tag"] == "testcase");
  CHECK(beyond["is"] == nlohmann::json({{"classname", "trace diff"}, {"name", "beyond"}}));
  CHECK(beyond["in"][0]["tag"] == "failure");
  CHECK(beyond["in"][0]["is"] == nlohmann::json({{"type", "beyond"}, {"message", "RMSE 3.25 is over 0.5"}}));
  CHECK(beyond["in"][0]["text"] ==
        "reference A/beyond.png\ntest      B/beyond.png\ndiagnosis shadows are missing\n"
        "RMSE 3.25, largest 16 at (3, 1), 12.5 % of pixels over 1 level");
  CHECK(suite["in"][1]["in"].empty());
  const nlohmann::json& missing = suite["in"][3];
  CHECK(missing["is"] == nlohmann::json({{"classname", "simple"}, {"name", "lost"}}));
  CHECK(missing["in"][0]["tag"] == "error");
  CHECK(missing["in"][0]["is"]["type"] == "missing");
}

TEST_CASE("nothing in a name or message can break JUnit's XML") {
  const JUnitCase odd{
      "<&>", "a\"b'\x01\x1B[31m", JUnitCase::Outcome::error, "x", "]]> \xFF & \x7F", "1 < 2\n\x02", 0.25};
  const nlohmann::json suite = parsed(junit_xml("s", {odd}))["in"][0];
  CHECK(suite["is"]["time"] == "0.250");
  const nlohmann::json& one = suite["in"][0];
  CHECK(one["is"] == nlohmann::json({{"classname", "<&>"}, {"name", "a\"b'[31m"}, {"time", "0.250"}}));
  CHECK(one["in"][0]["is"]["message"] == "]]> \xEF\xBF\xBD & \x7F");
  CHECK(one["in"][0]["text"] == "1 < 2");
}

}  // namespace trace::test
