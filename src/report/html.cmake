# The HTML report: its code, and the page's own files compiled in as strings. The scripts are put together in the order
# given here, into one function, so that they share their names.
target_sources(trace_report PRIVATE html.cpp html_picture_data.cpp html_pictures.cpp html_text.cpp)

set(html_scripts
  elements.js theme.js results.js text.js header.js pictures.js filter.js list.js matrix.js charts.js histogram.js
  scatter.js stage.js probe.js stage_tools.js crops.js facts.js detail.js keys.js main.js)
set(html_styles base.css list.css detail.css print.css)
list(TRANSFORM html_scripts PREPEND assets/)
list(TRANSFORM html_styles PREPEND assets/)

set(html_files
  assets/page.html ${html_styles} ${html_scripts}
  vendor/uplot/LICENSE vendor/uplot/uPlot.iife.min.js vendor/uplot/uPlot.min.css
  vendor/img-comparison-slider/LICENSE vendor/img-comparison-slider/img-comparison-slider.js
  vendor/img-comparison-slider/styles.css)
set(html_assets ${CMAKE_CURRENT_BINARY_DIR}/html_assets.cpp)
list(JOIN html_scripts "|" html_scripts_joined)
list(JOIN html_styles "|" html_styles_joined)
add_custom_command(
  OUTPUT ${html_assets}
  COMMAND ${CMAKE_COMMAND}
    "-DOUTPUT=${html_assets}" "-DSCRIPTS=${html_scripts_joined}" "-DSTYLES=${html_styles_joined}"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/html_assets.cmake
  WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
  DEPENDS ${html_files} html_assets.cmake
  VERBATIM)
target_sources(trace_report PRIVATE ${html_assets})
