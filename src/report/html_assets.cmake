# Writes OUTPUT, the definitions of html_assets.hpp, from the pages' files in assets/ and vendor/.
# html_PAGE_scripts, html_PAGE_styles, for the pages batch and study: our own files in order, separated by "|". Runs in
# src/report.
cmake_minimum_required(VERSION 3.25)

set(joined ${OUTPUT}.part)

function(append_file file)
  file(READ ${file} text)
  # A browser's tools would look for the map beside the page.
  string(REGEX REPLACE "//# sourceMappingURL=[^\n]*" "" text "${text}")
  file(APPEND ${joined} "${text}\n")
endfunction()

# A licence as a comment of CSS and JavaScript.
function(append_licence file)
  file(APPEND ${joined} "/*\n")
  append_file(${file})
  file(APPEND ${joined} "*/\n")
endfunction()

# Turns what was appended into a function of that name, and starts afresh. A character a literal: compilers limit the
# length of strings.
function(finish_asset name)
  file(READ ${joined} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  file(APPEND ${OUTPUT}
    "std::string_view ${name}() {\n  static constexpr char text[] = {${bytes}};\n"
    "  return {text, sizeof text};\n}\n\n")
  file(WRITE ${joined} "")
endfunction()

file(WRITE ${OUTPUT}
  "// Made from src/report/assets and src/report/vendor by html_assets.cmake.\n"
  "#include \"report/html_assets.hpp\"\n\nnamespace trace::html {\n\n")
file(WRITE ${joined} "")

append_file(assets/page.html)
finish_asset(page)

append_licence(vendor/uplot/LICENSE)
append_file(vendor/uplot/uPlot.iife.min.js)
append_licence(vendor/img-comparison-slider/LICENSE)
append_file(vendor/img-comparison-slider/img-comparison-slider.js)
finish_asset(libraries)

append_licence(vendor/uplot/LICENSE)
append_file(vendor/uplot/uPlot.min.css)
append_licence(vendor/img-comparison-slider/LICENSE)
append_file(vendor/img-comparison-slider/styles.css)
finish_asset(library_style)

foreach(page IN ITEMS batch study)
  string(REPLACE "|" ";" styles "${html_${page}_styles}")
  foreach(file IN LISTS styles)
    append_file(${file})
  endforeach()
  finish_asset(${page}_style)

  string(REPLACE "|" ";" scripts "${html_${page}_scripts}")
  file(APPEND ${joined} "(() => {\n\"use strict\";\n")
  foreach(file IN LISTS scripts)
    append_file(${file})
  endforeach()
  file(APPEND ${joined} "})();\n")
  finish_asset(${page}_script)
endforeach()

file(APPEND ${OUTPUT} "}  // namespace trace::html\n")
file(REMOVE ${joined})
