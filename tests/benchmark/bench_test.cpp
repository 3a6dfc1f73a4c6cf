// tools/bench, by the checks of bench_test.py. Nothing here depends on how long anything takes.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

// Of the checks of one class.
void check(const std::string& checks) {
  const TemporaryFolder folder;
  const auto printed = folder / "printed";
  const auto build = std::filesystem::path(TRACE_PROGRAM).parent_path();
  const int status = std::system(("/usr/bin/python3 '" TRACE_SOURCE_DIR
                                  "/tests/benchmark/bench_test.py' '" TRACE_SOURCE_DIR "' '" +
                                  build.string() + "' " + checks + " >'" + printed.string() + "' 2>&1")
                                     .c_str());
  INFO(read_text(printed));
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}

}  // namespace

TEST_CASE("the benchmark computes ratios by rounds and exponents by least squares") {
  check("Arithmetic");
}

TEST_CASE("the benchmark judges by the goals and calls only changes beyond the spread") {
  check("Goals");
}

TEST_CASE("the benchmark fills the tables of a page and draws a bar a goal") {
  check("Page");
}

TEST_CASE("the benchmark runs every stage in its quick form") {
  check("Quick");
}

}  // namespace trace::test
