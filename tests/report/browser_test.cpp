// The HTML reports of real renderings in a real browser. What is checked there is in browser_test.py and
// study_browser_test.py.
// The pages and screenshots stay in the build folder, in report-test/ and
// study-report-test/.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "report/html.hpp"
#include "report/study_svg.hpp"
#include "tests/report/sample_batch.hpp"
#include "tests/report/sample_study.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

constexpr int browser_absent = 77;

// Of a program in this folder with these arguments; `output` gets what it printed.
int run_browser(const std::string& program, const std::string& arguments, std::string& output) {
  const TemporaryFolder folder;
  const auto printed = folder / "printed";
  const int status = std::system(("/usr/bin/python3 '" TRACE_SOURCE_DIR "/tests/report/" + program + "' " +
                                  arguments + " >'" + printed.string() + "' 2>&1")
                                     .c_str());
  output = read_text(printed);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void check_in_browser(const std::string& program, const std::filesystem::path& folder) {
  std::string output;
  const int status = run_browser(program, "'" + folder.string() + "'", output);
  if (status == browser_absent) {
    WARN("not tested in a browser: " + output);
    return;
  }
  INFO(output);
  CHECK(status == 0);
}

std::filesystem::path page_folder(const char* name) {
  const auto folder = std::filesystem::path(TRACE_PROGRAM).parent_path() / name;
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace

TEST_CASE("the report of a batch works in a browser") {
  const auto folder = page_folder("report-test");
  const auto report = sample_batch(folder);
  write_html_report(report, folder / "one.html");
  write_html_report(report, folder / "linked.html", {.embed_pictures = false});
  write_html_report(with_second_renderer(report), folder / "two.html");
  check_in_browser("browser_test.py", folder);
}

TEST_CASE("the report of a study works in a browser") {
  const auto folder = page_folder("study-report-test");
  const SampleStudy study = sample_study(folder);
  write_study_report(study.report, study.pictures, folder / "study.html");
  write_study_report(made_up_study(300, 30), {}, folder / "large.html");
  write_text(folder / "study.svg", study_svg(study.report));
  check_in_browser("study_browser_test.py", folder);
}

}  // namespace trace::test
