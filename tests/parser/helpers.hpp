// Short ways to say what a test is about.
#pragma once

#include <string>
#include <string_view>

#include "parser/parse.hpp"

namespace trace::parser::test {

// The scene that `text` describes; the test fails if it has errors.
Scene scene_of(const std::string& text);

// The report on a scene with the line "SBT-raytracer 1.0" and then `body`, without the excerpts: one line for
// each error and note, "line:column: error: text". Empty where there is nothing to report.
std::string messages(const std::string& body);

// The same for a whole file's text.
std::string messages_of_file(const std::string& text);

// The report as a user sees it.
std::string report(const std::string& text);

inline const std::string header = "SBT-raytracer 1.0\n";

}  // namespace trace::parser::test
