// `trace [options] scene.ray out.png`: exit statuses, messages, what is written where.
#include <catch2/catch.hpp>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

constexpr const char* plain_scene =
    "SBT-raytracer 1.0\nsquare { material = { emissive = (1, 0.5, 0.25); } }\n"
    "camera { position = (0, 0, 1); }\n";

struct Desk {
  TemporaryFolder folder;
  Desk() { write_text(folder.path() / "a.ray", plain_scene); }
  Outcome trace(const std::string& arguments, const std::string& input = "") const {
    return run_trace(folder.path(), arguments, {}, input);
  }
  bool has(const std::string& file) const { return std::filesystem::exists(folder.path() / file); }
  Image image(const std::string& file) const { return read_image(folder.path() / file); }
};

}  // namespace

TEST_CASE("a scene becomes a picture and nothing is printed") {
  const Desk desk;
  const Outcome outcome = desk.trace("a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors.empty());
  CHECK(outcome.output.empty());
  const Image image = desk.image("out.png");
  CHECK(image.width == 512);
  CHECK(image.height == 512);
  const std::size_t centre = (256u * 512u + 256u) * 3u;
  CHECK(int{image.rgb[centre]} == 255);
  CHECK(int{image.rgb[centre + 1]} == 127);
  CHECK(int{image.rgb[centre + 2]} == 63);
}

TEST_CASE("the course's options are understood as its scripts write them") {
  const Desk desk;
  write_text(desk.folder.path() / "s.json", "{\"shadows\": false}");
  CHECK(desk.trace("-r 5 -w 32 -j s.json a.ray out.png").status == 0);
  CHECK(desk.image("out.png").width == 32);
  CHECK(desk.trace("-r5 -w16 a.ray out.png").status == 0);
  CHECK(desk.image("out.png").width == 16);
  CHECK(desk.trace("a.ray out.png -w 8").status == 0);
  CHECK(desk.image("out.png").width == 8);
  CHECK(desk.trace("-r -1 -w 8 a.ray out.png").status == 0);
}

TEST_CASE("a scene comes from standard input") {
  const Desk desk;
  CHECK(desk.trace("-w 4 - out.png", plain_scene).status == 0);
  CHECK(desk.image("out.png").width == 4);
  const Outcome wrong = desk.trace("-w 4 - no.png", "SBT-raytracer 1.0\nsphere [\n");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.errors, Catch::StartsWith("<stdin>:2:8: error: unexpected character '['\n"));
  CHECK(!desk.has("no.png"));
}

TEST_CASE("a picture is a BMP where its name says so, with the same pixels") {
  const Desk desk;
  CHECK(desk.trace("-w 33 a.ray out.png").status == 0);
  CHECK(desk.trace("-w 33 a.ray out.BMP").status == 0);
  CHECK(read_text(desk.folder.path() / "out.BMP").substr(0, 2) == "BM");
  CHECK(compare(desk.image("out.png"), desk.image("out.BMP")).pixels == 0);
}

TEST_CASE("a scene that is missing or no file is exit status 1") {
  const Desk desk;
  const Outcome missing = desk.trace("b.ray out.png");
  CHECK(missing.status == 1);
  CHECK(missing.errors == "trace: error: cannot read 'b.ray': no such file\n");
  const Outcome folder = desk.trace(". out.png");
  CHECK(folder.status == 1);
  CHECK(folder.errors == "trace: error: cannot read '.': it is a directory\n");
  CHECK(!desk.has("out.png"));
}

TEST_CASE("a picture that cannot be written is exit status 3, found before the scene is rendered") {
  const Desk desk;
  const Outcome no_folder = desk.trace("a.ray no/out.png");
  CHECK(no_folder.status == 3);
  CHECK_THAT(no_folder.errors, Catch::StartsWith("trace: error: cannot write 'no/out.png': "));
  const Outcome no_type = desk.trace("b.ray out");
  CHECK(no_type.status == 3);
  CHECK(no_type.errors ==
        "trace: error: cannot write 'out': the name has no extension that tells the type of picture\n");
  const Outcome odd_type = desk.trace("a.ray out.xyz");
  CHECK(odd_type.status == 3);
  CHECK(odd_type.errors == "trace: error: cannot write 'out.xyz': cannot write pictures of type '.xyz'\n");
}

TEST_CASE("an error leaves the picture of before as it was") {
  const Desk desk;
  REQUIRE(desk.trace("-w 5 a.ray out.png").status == 0);
  const std::string before = read_text(desk.folder.path() / "out.png");
  write_text(desk.folder.path() / "a.ray", "SBT-raytracer 1.0\nsphere { radius = 1; }\n");
  CHECK(desk.trace("-w 5 a.ray out.png").status == 1);
  CHECK(read_text(desk.folder.path() / "out.png") == before);
}

TEST_CASE("a command line that cannot be used is exit status 2 and says how to go on") {
  const Desk desk;
  for (const char* arguments : {"", "a.ray", "--fast a.ray out.png", "-w 0 a.ray out.png",
                                "-w -5 a.ray out.png", "-w 65537 a.ray out.png", "-w abc a.ray out.png",
                                "-r 1001 a.ray out.png", "-t 0 a.ray out.png", "-w", "a.ray out.png more"}) {
    INFO(arguments);
    const Outcome outcome = desk.trace(arguments);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.errors, Catch::StartsWith("trace: error: "));
    CHECK_THAT(outcome.errors, Catch::EndsWith("Run 'trace --help' for how to use it.\n"));
    CHECK(!desk.has("out.png"));
  }
}

TEST_CASE("help has examples and the version names itself") {
  const Desk desk;
  const Outcome help = desk.trace("--help");
  CHECK(help.status == 0);
  CHECK_THAT(help.output, Catch::Contains("Examples:") && Catch::Contains("-c,--cubemap"));
  CHECK(desk.trace("-h").output == help.output);
  const Outcome version = desk.trace("--version");
  CHECK(version.status == 0);
  CHECK_THAT(version.output, Catch::StartsWith("trace 0."));
}

TEST_CASE("statistics count what was traced") {
  const Desk desk;
  const Outcome outcome = desk.trace("--stats -w 10 a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.errors, Catch::Contains("1 objects, 0 triangles, 0 lights, 0 textures\n") &&
                                 Catch::Contains("picture  10 x 10\n") &&
                                 Catch::Contains("100 primary, 0 reflected, 0 refracted, 0 shadow\n"));
}

TEST_CASE("statistics say what was left out and why") {
  const Desk desk;
  write_text(desk.folder.path() / "plain.ray",
             "SBT-raytracer 1.0\npoint_light { position = (0,0,3); color = (1,1,1); }\n"
             "sphere { material = { diffuse = (1,0,0); } }\n");
  const Outcome plain = desk.trace("--stats --instruction-set baseline -w 4 plain.ray out.png");
  CHECK_THAT(plain.errors, Catch::Contains("kernels  baseline\n"
                                           "hierarchy none: a handful of objects is a list\n"
                                           "left out refracted rays, and shadow rays behind their first hit "
                                           "(nothing lets light through)\n"
                                           "left out reflected rays (nothing mirrors)\n"
                                           "left out powers of highlights (nothing is specular)\n"));
  write_text(desk.folder.path() / "glass.ray",
             "SBT-raytracer 1.0\npoint_light { position = (0,0,3); color = (1,1,1); }\n"
             "sphere { material = { specular = (1,0,0); reflective = (1,1,1); transmissive = (1,1,1); } }\n");
  const Outcome glass = desk.trace("--stats -w 4 glass.ray out.png");
  CHECK(glass.status == 0);
  for (const char* used : {"left out refracted", "left out reflected", "left out powers"}) {
    CHECK_THAT(glass.errors, !Catch::Contains(used));
  }
}

TEST_CASE("an instruction set is asked for by name and changes no picture") {
  const Desk desk;
  CHECK(desk.trace("-q --instruction-set baseline -w 16 a.ray baseline.png").status == 0);
  CHECK(desk.trace("-q -w 16 a.ray best.png").status == 0);
  CHECK(read_text(desk.folder.path() / "baseline.png") == read_text(desk.folder.path() / "best.png"));
  const Outcome unknown = desk.trace("--instruction-set mmx a.ray out.png");
  CHECK(unknown.status == 2);
  CHECK(unknown.errors ==
        "trace: error: --instruction-set: 'mmx' is none of baseline, sse4, avx2 and avx512\n"
        "Run 'trace --help' for how to use it.\n");
}

TEST_CASE("a cube map that cannot be used is a warning and the picture is drawn without it") {
  const Desk desk;
  const Outcome outcome = desk.trace("-w 4 -c nowhere/posx.png a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors ==
        "trace: warning: no cube map: cannot read the folder 'nowhere': No such file or directory\n");
  CHECK(desk.has("out.png"));
  CHECK(desk.trace("-q -w 4 -c nowhere/posx.png a.ray out.png").errors.empty());
}

TEST_CASE("a picture out of bounds is an error at the aspect ratio") {
  const Desk desk;
  write_text(desk.folder.path() / "a.ray", "SBT-raytracer 1.0\ncamera { aspectratio = 1e-5; }\n");
  const Outcome high = desk.trace("a.ray out.png");
  CHECK(high.status == 1);
  CHECK_THAT(
      high.errors,
      Catch::StartsWith("a.ray:2:24: error: a picture 512 pixels wide would be 51200000 pixels "
                        "high at this aspect ratio; the limits are 65536 pixels a side and 268435456 in "
                        "all\n"));
  write_text(desk.folder.path() / "a.ray", "SBT-raytracer 1.0\ncamera { aspectratio = 1e5; }\n");
  const Outcome flat = desk.trace("a.ray out.png");
  CHECK(flat.status == 1);
  CHECK_THAT(
      flat.errors,
      Catch::StartsWith("a.ray:2:24: error: a picture 512 pixels wide would have no rows at this aspect "
                        "ratio\n"));
  CHECK(!desk.has("out.png"));
}

TEST_CASE("a texture that cannot be read is an error at its place") {
  const Desk desk;
  write_text(desk.folder.path() / "a.ray",
             "SBT-raytracer 1.0\nbox { material = { diffuse = map(\"no.png\"); } }\n");
  const Outcome outcome = desk.trace("a.ray out.png");
  CHECK(outcome.status == 1);
  CHECK(outcome.errors ==
        "a.ray:2:30: error: cannot read texture 'no.png': no such file\n"
        "box { material = { diffuse = map(\"no.png\"); } }\n"
        "                             ^~~~~~~~~~~~~\n");
}

TEST_CASE("100 000 nested transforms are drawn and one more is an error") {
  const Desk desk;
  const auto nested = [](int depth) {
    std::string text = "SBT-raytracer 1.0\n";
    for (int i = 0; i < depth; ++i) text += "translate(0,0,0,";
    text += "sphere { }";
    return text + std::string(static_cast<std::size_t>(depth), ')');
  };
  write_text(desk.folder.path() / "a.ray", nested(100'000));
  CHECK(desk.trace("-w 4 a.ray out.png").status == 0);
  write_text(desk.folder.path() / "a.ray", nested(100'001));
  const Outcome outcome = desk.trace("-w 4 a.ray no.png");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.errors, Catch::Contains("100000"));
}

TEST_CASE("a ray tree of the greatest depth is drawn") {
  const Desk desk;
  write_text(desk.folder.path() / "a.ray",
             "SBT-raytracer 1.0\nmaterial = { reflective = (1, 1, 1); }\n"
             "translate(0, 0, -1, scale(1e4, square { })) translate(0, 0, 1, scale(1e4, square { }))\n");
  const Outcome outcome = desk.trace("-r 1000 -w 1 --stats a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.errors, Catch::Contains("1 primary, 1000 reflected, "));
}

}  // namespace trace::test
