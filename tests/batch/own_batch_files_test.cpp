// The batch.json files of the project's own scenes.
#include <catch2/catch.hpp>
#include <sstream>

#include "batch/batch_files.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

const std::filesystem::path own_scenes = std::filesystem::path(TRACE_SOURCE_DIR) / "scenes";

// The word after an option; "" where it is not given.
std::string argument(const std::string& arguments, const std::string& option) {
  std::istringstream words(arguments);
  for (std::string word, value; words >> word >> value;) {
    if (word == option) return value;
  }
  return "";
}

}  // namespace

TEST_CASE("a batch of our scenes asks for what their solutions were drawn with") {
  std::string messages;
  BatchFiles files(own_scenes, messages);
  for (const auto& row : read_table(own_scenes / "manifest.tsv")) {
    INFO(row[0]);
    const auto options = files.of(row[0]);
    REQUIRE(options);
    CHECK(options->width.value_or(512) == std::stoi(argument(row[1], "-w")));
    CHECK(options->depth.value_or(5) == std::stoi(argument(row[1], "-r")));
    CHECK(options->settings.empty() == argument(row[1], "-j").empty());
    const std::string cube_map = argument(row[1], "-c");
    REQUIRE(options->cube_map.has_value() == !cube_map.empty());
    if (options->cube_map) CHECK(std::filesystem::equivalent(*options->cube_map, own_scenes / cube_map));
  }
  CHECK(messages == "");
  CHECK(files.valid());
}

}  // namespace trace::test
