#include "helpers.hpp"

#include <catch2/catch.hpp>
#include <sstream>

namespace trace::parser::test {

Scene scene_of(const std::string& text) {
  const Source source = Source::from_text("scene.ray", text);
  Diagnostics diagnostics;
  Scene scene = parse(source, diagnostics);
  INFO(render(source, diagnostics));
  REQUIRE_FALSE(diagnostics.has_errors());
  return scene;
}

std::string report(const std::string& text) {
  const Source source = Source::from_text("scene.ray", text);
  Diagnostics diagnostics;
  parse(source, diagnostics);
  return render(source, diagnostics);
}

std::string messages_of_file(const std::string& text) {
  std::istringstream lines(report(text));
  std::string result;
  const std::string name = "scene.ray:";
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, name.size(), name) == 0) result += line.substr(name.size()) + "\n";
  }
  return result;
}

std::string messages(const std::string& body) {
  return messages_of_file(header + body);
}

}  // namespace trace::parser::test
