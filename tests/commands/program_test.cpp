// The program as a file: what it is linked to, and what it does where a part of it is missing.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/picture_table.hpp"

namespace trace::test {

TEST_CASE("the program is not linked to OpenImageIO") {
  const TemporaryFolder folder;
  const auto list = folder.path() / "ldd";
  REQUIRE(std::system(("ldd '" TRACE_PROGRAM "' >'" + list.string() + "'").c_str()) == 0);
  const std::string libraries = read_text(list);
  CHECK_THAT(libraries, Catch::Contains("libc.so"));
  CHECK_THAT(libraries, !Catch::Contains("OpenImageIO"));
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

}  // namespace trace::test
