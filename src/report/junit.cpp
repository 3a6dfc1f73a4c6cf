#include "report/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

#include "report/plain_text.hpp"

namespace trace {
namespace {

using Outcome = JUnitCase::Outcome;

void set(pugi::xml_node node, const char* attribute, const std::string& value) {
  node.append_attribute(attribute).set_value(xml_text(value).c_str());
}

void set_counts(pugi::xml_node node, const std::string& name, const std::vector<JUnitCase>& cases) {
  const auto count = [&](Outcome outcome) {
    return fmt::format("{}", std::ranges::count(cases, outcome, &JUnitCase::outcome));
  };
  double seconds = 0;
  for (const JUnitCase& one : cases) seconds += one.seconds.value_or(0);
  set(node, "name", name);
  set(node, "tests", fmt::format("{}", cases.size()));
  set(node, "failures", count(Outcome::failure));
  set(node, "errors", count(Outcome::error));
  set(node, "time", fmt::format("{:.3f}", seconds));
}

void add_case(pugi::xml_node suite, const JUnitCase& one) {
  pugi::xml_node node = suite.append_child("testcase");
  set(node, "classname", one.group);
  set(node, "name", one.name);
  if (one.seconds) set(node, "time", fmt::format("{:.3f}", *one.seconds));
  if (one.outcome == Outcome::passed) return;
  pugi::xml_node problem = node.append_child(one.outcome == Outcome::failure ? "failure" : "error");
  set(problem, "type", one.type);
  set(problem, "message", one.message);
  if (!one.details.empty()) problem.append_child(pugi::node_pcdata).set_value(xml_text(one.details).c_str());
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<JUnitCase>& cases) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version").set_value("1.0");
  declaration.append_attribute("encoding").set_value("UTF-8");
  pugi::xml_node suites = document.append_child("testsuites");
  set_counts(suites, suite, cases);
  pugi::xml_node node = suites.append_child("testsuite");
  set_counts(node, suite, cases);
  for (const JUnitCase& one : cases) add_case(node, one);
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

}  // namespace trace
