// The program as a file: what it is linked to, and what it does where a part of it is missing.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string_view>

#include "tests/support/picture_table.hpp"

namespace trace::test {

TEST_CASE("neither form of the program is linked to OpenImageIO") {
  const TemporaryFolder folder;
  const auto list = folder.path() / "ldd";
  for (const std::string program : {TRACE_PROGRAM, TRACE_DYNAMIC_PROGRAM}) {
    REQUIRE(std::system(("ldd '" + program + "' >'" + list.string() + "'").c_str()) == 0);
    const std::string libraries = read_text(list);
    CHECK_THAT(libraries, Catch::Contains("libc.so") || Catch::Contains("statically linked"));
    CHECK_THAT(libraries, !Catch::Contains("OpenImageIO"));
  }
}

TEST_CASE("a picture of another format is written and read through the module") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray",
             "SBT-raytracer 1.0\ncamera { position=(0,0,1); }\n"
             "square { material={ emissive=(1,1,1); } }\n");
  REQUIRE(run_trace(folder.path(), "-w 16 a.ray white.tif").status == 0);
  write_text(folder.path() / "b.ray",
             "SBT-raytracer 1.0\ncamera { position=(0,0,1); }\n"
             "square { material={ emissive=map(\"white.tif\"); } }\n");
  const Outcome outcome = run_trace(folder.path(), "-w 16 b.ray out.png");
  CHECK(outcome.errors.empty());
  REQUIRE(outcome.status == 0);
  CHECK(compare(read_image(folder.path() / "white.tif"), read_image(folder.path() / "out.png")).pixels == 0);
}

TEST_CASE("what can be read only once is not lost where OpenImageIO is found to be needed later") {
  const TemporaryFolder folder;
  const std::filesystem::path texture = folder.path() / "white.tif";
  write_image(texture, {2, 2, std::vector<std::uint8_t>(12, 255)});
  const std::string scene =
      "SBT-raytracer 1.0\ncamera { position=(0,0,1); }\n"
      "square { material={ emissive=map(\"" +
      texture.string() + "\"); } }\n";
  write_text(folder.path() / "a.ray", scene);
  REQUIRE(run_trace(folder.path(), "-w 16 a.ray file.png").status == 0);
  const Outcome outcome = run_trace(folder.path(), "-w 16 - input.png", {}, scene);
  CHECK(outcome.errors.empty());
  CHECK(outcome.status == 0);
  const std::string pipe =
      "cd '" + folder.path().string() + "' && cat a.ray | '" TRACE_PROGRAM "' -w 16 /dev/stdin pipe.png";
  CHECK(std::system(pipe.c_str()) == 0);
  const Image expected = read_image(folder.path() / "file.png");
  for (const char* name : {"input.png", "pipe.png"})
    CHECK(compare(read_image(folder.path() / name), expected).pixels == 0);
}

TEST_CASE("without its module the program still draws, and says which package other formats need") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray", "SBT-raytracer 1.0\n");
  std::filesystem::copy_file(TRACE_PROGRAM, folder.path() / "trace");
  const auto run = [&](const std::string& output) {
    return std::system(
        ("cd '" + folder.path().string() + "' && ./trace -w 4 a.ray " + output + " 2>errors").c_str());
  };
  CHECK(run("out.png") == 0);
  CHECK(run("out.tif") != 0);
  CHECK_THAT(read_text(folder.path() / "errors"),
             Catch::Contains("OpenImageIO") && Catch::Contains("libopenimageio2.4"));
}

TEST_CASE("where the program has two forms, the first alone does all but the formats of OpenImageIO") {
  if (std::string_view(TRACE_PROGRAM) == TRACE_DYNAMIC_PROGRAM) return;
  const TemporaryFolder folder;
  std::filesystem::copy_file(TRACE_PROGRAM, folder.path() / "trace");
  write_image(folder.path() / "a.png", {2, 2, std::vector<std::uint8_t>(12, 255)});
  write_image(folder.path() / "a.tif", {2, 2, std::vector<std::uint8_t>(12, 255)});
  const auto status_of = [&](const std::string& arguments) {
    return WEXITSTATUS(
        std::system(("cd '" + folder.path().string() + "' && ./trace " + arguments + " >out 2>&1").c_str()));
  };
  CHECK(status_of("diff a.png a.png") == 0);
  CHECK(status_of("batch --help") == 0);
  CHECK(status_of("diff a.png a.tif") == 3);
  CHECK_THAT(read_text(folder.path() / "out"), Catch::Contains("reading TIFF needs OpenImageIO") &&
                                                   Catch::Contains("and trace_dynamic beside the program"));
}

}  // namespace trace::test
