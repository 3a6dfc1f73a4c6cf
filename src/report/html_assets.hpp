// The parts of the reports' pages, from src/report/assets and src/report/vendor; html_assets.cmake puts them
// together at build time.
#pragma once

#include <string_view>

namespace trace::html {

std::string_view page();           // with {{name}} where html_page.cpp puts something in
std::string_view libraries();      // JavaScript of others, with their licences
std::string_view library_style();  // their CSS

// CSS and JavaScript of ours, of each kind of page.
std::string_view batch_style();
std::string_view batch_script();
std::string_view study_style();
std::string_view study_script();

}  // namespace trace::html
