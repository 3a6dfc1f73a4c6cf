// The parts of the report's page, from src/report/assets and src/report/vendor; html_assets.cmake puts them
// together at build time.
#pragma once

#include <string_view>

namespace trace::html {

std::string_view page();       // with {{name}} where html.cpp puts something in
std::string_view style();      // CSS
std::string_view libraries();  // JavaScript of others, with their licences
std::string_view script();     // JavaScript of ours

}  // namespace trace::html
