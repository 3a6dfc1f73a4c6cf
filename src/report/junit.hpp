// JUnit's XML, by which servers for continuous integration show the results of tests: testsuites, testsuite,
// testcase, with <failure> for a wrong result and <error> where there is none. There is no official schema;
// this keeps to what Jenkins, GitLab and GitHub's reporters read.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trace {

struct JUnitCase {
  enum class Outcome { passed, failure, error };

  std::string group;  // "simple", shown as a class
  std::string name;   // "box"
  Outcome outcome = Outcome::passed;
  std::string type;               // "beyond", of a failure or error
  std::string message;            // one line
  std::string details;            // several lines
  std::optional<double> seconds;  // where it was measured
};

// One suite. Text is made fit for XML (plain_text.hpp).
std::string junit_xml(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace trace
