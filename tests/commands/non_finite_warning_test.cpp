// What is said of a picture with colours that are infinite or undefined.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

// A square in the middle of a window of 5 x 5, undefined in green: of 11 x 11 pixels columns 5 and 6, rows 4
// and 5.
constexpr const char* odd_scene =
    "SBT-raytracer 1.0\nsquare { material = { emissive = (0.2, 0.2, 0.2); transmissive = (0.5, 0, 1); } }\n"
    "camera { position = (0, 0, 5); }\n";
constexpr const char* warning =
    ": warning: 4 pixels have a colour that is not finite, the first at (5, 4): green is undefined and drawn "
    "black\n";

}  // namespace

TEST_CASE("a picture with an undefined colour is written, and a warning tells how many pixels and where") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray", odd_scene);
  const Outcome outcome = run_trace(folder.path(), "-w 11 a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors == std::string("a.ray") + warning);
  const Image image = read_image(folder.path() / "out.png");
  const std::size_t first = (4u * 11u + 5u) * 3u;
  CHECK(int{image.rgb[first]} == 51);
  CHECK(int{image.rgb[first + 1]} == 0);
  CHECK(run_trace(folder.path(), "-w 11 - out.png", {}, odd_scene).errors ==
        std::string("<stdin>") + warning);
  CHECK(run_trace(folder.path(), "-q -w 11 a.ray out.png").errors.empty());
  CHECK(
      run_trace(folder.path(), "-r 0 -w 11 a.ray out.png").errors.empty());  // no ray goes through the square
}

TEST_CASE("a batch keeps the warning of undefined colours with the scene") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "scenes");
  write_text(folder.path() / "scenes/a.ray", odd_scene);
  const Outcome outcome = run_trace(folder.path(), "batch scenes -o out -w 11");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.errors, Catch::Contains(std::string("scenes/a.ray") + warning));
  const auto results = nlohmann::json::parse(read_text(folder.path() / "out/results.json"));
  CHECK(results.at("results").at(0).at("message") == std::string("scenes/a.ray") + warning);
}

}  // namespace trace::test
