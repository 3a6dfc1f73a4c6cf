# The HTML reports: their code, and the pages' own files compiled in as strings. The scripts of a page are put together
# in the order given here, into one function, so that they share their names. What is not in batch/ or study/ is shared.
target_sources(trace_report PRIVATE
  html.cpp html_page.cpp html_picture_data.cpp html_pictures.cpp html_text.cpp study_html.cpp)

set(html_batch_scripts
  elements.js theme.js text.js order.js batch/results.js batch/header.js pictures.js batch/filter.js batch/list.js
  batch/matrix.js charts.js pointer.js batch/histogram.js batch/scatter.js stage.js probe.js stage_tools.js
  batch/crops.js batch/facts.js dialog.js batch/detail.js keys.js batch/keys.js batch/main.js)
set(html_batch_styles base.css list.css batch/matrix.css detail.css print.css)
set(html_study_scripts
  elements.js theme.js text.js order.js study/data.js study/figures.js study/fastest.js study/shapes.js study/header.js
  pictures.js charts.js pointer.js study/marks.js study/zoom.js study/plot.js study/steps.js study/legend.js
  study/overall.js study/claims.js study/table.js study/settings.js study/list.js stage.js probe.js stage_tools.js
  dialog.js study/copy.js study/results.js study/answers.js study/pictures.js study/detail.js keys.js study/keys.js
  study/main.js)
set(html_study_styles base.css list.css detail.css study/study.css print.css)

set(html_files
  assets/page.html vendor/uplot/LICENSE vendor/uplot/uPlot.iife.min.js vendor/uplot/uPlot.min.css
  vendor/img-comparison-slider/LICENSE vendor/img-comparison-slider/img-comparison-slider.js
  vendor/img-comparison-slider/styles.css)
set(html_lists)
foreach(list IN ITEMS html_batch_scripts html_batch_styles html_study_scripts html_study_styles)
  list(TRANSFORM ${list} PREPEND assets/)
  list(APPEND html_files ${${list}})
  list(JOIN ${list} "|" joined)
  list(APPEND html_lists "-D${list}=${joined}")
endforeach()
list(REMOVE_DUPLICATES html_files)
set(html_assets ${CMAKE_CURRENT_BINARY_DIR}/html_assets.cpp)
add_custom_command(
  OUTPUT ${html_assets}
  COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${html_assets}" ${html_lists} -P ${CMAKE_CURRENT_SOURCE_DIR}/html_assets.cmake
  WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
  DEPENDS ${html_files} html_assets.cmake
  VERBATIM)
target_sources(trace_report PRIVATE ${html_assets})
