// The HTML report of real renderings in a real browser. What is checked there is in browser_test.py.
// The pages and screenshots stay in the build folder, in report-test/.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "report/html.hpp"
#include "tests/report/sample_batch.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

constexpr int browser_absent = 77;

// Of browser_test.py with these arguments; `output` gets what it printed.
int run_browser(const std::string& arguments, std::string& output) {
  const TemporaryFolder folder;
  const auto printed = folder / "printed";
  const int status = std::system(("/usr/bin/python3 '" TRACE_SOURCE_DIR "/tests/report/browser_test.py' " +
                                  arguments + " >'" + printed.string() + "' 2>&1")
                                     .c_str());
  output = read_text(printed);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("the report of a batch works in a browser") {
  const auto folder = std::filesystem::path(TRACE_PROGRAM).parent_path() / "report-test";
  std::filesystem::create_directories(folder);
  const auto report = sample_batch(folder);
  write_html_report(report, folder / "one.html");
  write_html_report(report, folder / "linked.html", {.embed_pictures = false});
  write_html_report(with_second_renderer(report), folder / "two.html");

  std::string output;
  const int status = run_browser("'" + folder.string() + "'", output);
  if (status == browser_absent) {
    WARN("not tested in a browser: " + output);
    return;
  }
  INFO(output);
  CHECK(status == 0);
}

}  // namespace trace::test
