// `trace --stats` and `--stats-json`: what a scene needed, and what was left out.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/picture_table.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

using nlohmann::json;

constexpr const char* schema = "stats-1.schema.json";

struct StatsDesk {
  TemporaryFolder folder;

  json report(const std::string& scene, const std::string& arguments = "") const {
    write_text(folder.path() / "scene.ray", "SBT-raytracer 1.0\n" + scene);
    const Outcome outcome =
        run_trace(folder.path(), "-w 20 --stats-json stats.json " + arguments + " scene.ray out.png");
    CHECK(outcome.status == 0);
    CHECK(outcome.output.empty());
    const std::string text = read_text(folder.path() / "stats.json");
    CHECK(schema_faults(schema, text) == "");
    return json::parse(text);
  }
  std::string picture() const { return read_text(folder.path() / "out.png"); }
};

const json* stage(const json& report, const std::string& name) {
  for (const json& s : report.at("stages")) {
    if (s.at("stage") == name) return &s;
  }
  return nullptr;
}

constexpr const char* plain =
    "camera { position = (0,0,4); }\npoint_light { position = (0,0,9); color = (1,1,1); }\n"
    "sphere { material = { diffuse = (1,0,0); } }\n";
constexpr const char* rich =
    "camera { position = (0,0,4); }\n"
    "point_light { position = (0,0,9); color = (1,1,1); }\npoint_light { position = (1,0,9); color = "
    "(0,0,0); }\n"
    "translate(0,0,-2,square { material = { diffuse = map(\"a.png\"); specular = map(\"a.bmp\"); } })\n"
    "sphere { material = { diffuse = (1,0,0); reflective = (0.5,0.5,0.5); transmissive = (0.5,1,1); } }\n"
    "trimesh { points = ((0,0,0),(1,0,0),(0,1,0)); faces = ((0,1,2)); normals = ((0,0,1),(0,0,1),(0,1,1)); "
    "}\n"
    "translate(1,1,1,box { })\n";

}  // namespace

TEST_CASE("the report of a scene fits its published schema, whatever the scene needs") {
  const StatsDesk desk;
  for (const char* name : {"a.png", "a.bmp"})
    write_image(desk.folder.path() / name, {2, 2, std::vector<std::uint8_t>(12, 200)});
  const json little = desk.report(plain);
  const json much = desk.report(rich);
  const json all = desk.report(plain, "--model-everything");
  desk.report(plain, "--instruction-set baseline --least-contribution 0.5");
  desk.report("");  // nothing in it at all
  CHECK(little.at("everything_modelled") == false);
  CHECK(all.at("everything_modelled") == true);
  for (const auto& [need, is_needed] : little.at("needs").items()) {
    INFO(need);
    CHECK(is_needed == false);
  }
  for (const char* need : {"transmission", "reflection", "highlights", "maps", "smooth_normals"}) {
    INFO(need);
    CHECK(much.at("needs").at(need) == true);
  }
  CHECK(little.at("left_out").size() > much.at("left_out").size());
  CHECK(much.at("culled_lights") == json::parse(R"([{"light": 1, "why": "black"}])"));
  CHECK(little.at("hierarchy").is_null());
  CHECK(much.at("hierarchy").at("over") == "faces");
  CHECK(all.at("hierarchy").at("over") == "objects");
}

TEST_CASE("the schema of a report refuses what contradicts itself") {
  const StatsDesk desk;
  const json report = desk.report(plain);
  const auto changed = [&](const char* pointer, const json& value) {
    json document = report;
    document[json::json_pointer(pointer)] = value;
    return schema_faults(schema, document.dump());
  };
  CHECK_THAT(changed("/rays/shadow", -1), Catch::Contains("rays/shadow"));
  CHECK_THAT(changed("/stages/0/stage", "lunch"), Catch::Contains("stages/0/stage"));
  CHECK_THAT(changed("/needs/sugar", true), Catch::Contains("'sugar' was unexpected"));
  CHECK_THAT(changed("/version", 2), Catch::Contains("version"));
}

TEST_CASE("a scene without textures opens no codec, one with textures those it needs, each file once") {
  const StatsDesk desk;
  for (const char* name : {"a.png", "a.bmp", "a.tif"})
    write_image(desk.folder.path() / name, {2, 2, std::vector<std::uint8_t>(12, 200)});
  CHECK(desk.report(plain).at("decoded") ==
        json::parse(R"({"by_libpng":0,"by_stb":0,"by_openimageio":0,"file_bytes":0,"pixel_bytes":0})"));
  const json much = desk.report(std::string(rich) + "box { material = { diffuse = map(\"a.png\"); } }\n");
  CHECK(much.at("decoded").at("by_libpng") == 1);
  CHECK(much.at("decoded").at("by_stb") == 1);
  CHECK(much.at("decoded").at("by_openimageio") == 0);
  CHECK(much.at("decoded").at("pixel_bytes") == 24);
  CHECK(much.at("decoded").at("file_bytes") == std::filesystem::file_size(desk.folder.path() / "a.png") +
                                                   std::filesystem::file_size(desk.folder.path() / "a.bmp"));
  CHECK(stage(much, "textures")->at("bytes") == 24);
  const json tif = desk.report("box { material = { diffuse = map(\"a.tif\"); } }\n");
  CHECK(tif.at("decoded").at("by_openimageio") == 1);
}

TEST_CASE("everything modelled is counted and the picture is the same file") {
  const StatsDesk desk;
  const json needed = desk.report(plain, "-r 2");
  const std::string picture = desk.picture();
  const json all = desk.report(plain, "-r 2 --model-everything");
  CHECK(desk.picture() == picture);
  CHECK(needed.at("rays").at("reflected") == 0);
  CHECK(needed.at("work") == json::parse(R"({"highlights":0,"maps":0,"surroundings":0})"));
  CHECK(all.at("rays").at("reflected") > 0);
  CHECK(all.at("rays").at("refracted") > 0);
  for (const char* what : {"highlights", "maps", "surroundings"}) CHECK(all.at("work").at(what) > 0);
}

TEST_CASE("each stage tells its bytes: the text's, the picture's and the file's are exact") {
  const StatsDesk desk;
  const json report = desk.report(plain);
  CHECK(stage(report, "read")->at("bytes") == std::filesystem::file_size(desk.folder.path() / "scene.ray"));
  CHECK(stage(report, "render")->at("bytes") == 20 * 20 * 3);
  CHECK(stage(report, "write")->at("bytes") == std::filesystem::file_size(desk.folder.path() / "out.png"));
  CHECK(stage(report, "start")->at("bytes").is_null());
  for (const char* name : {"parse", "scene"}) CHECK(stage(report, name)->at("bytes") > 0);
  CHECK(stage(report, "hierarchy")->at("bytes") == 0);
  CHECK(report.at("peak_bytes") > 1 << 20);
}

TEST_CASE("a report goes to standard output where it is called -, beside the one on standard error") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray", std::string("SBT-raytracer 1.0\n") + plain);
  const Outcome outcome = run_trace(folder.path(), "-w 8 --stats --stats-json - a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK(schema_faults(schema, outcome.output) == "");
  CHECK_THAT(outcome.errors, Catch::StartsWith("scene    1 objects, 0 triangles, 1 lights, 0 textures\n"));
}

TEST_CASE("a report that cannot be written is exit status 3, before anything is rendered") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray", std::string("SBT-raytracer 1.0\n") + plain);
  const Outcome outcome = run_trace(folder.path(), "-w 8 --stats-json no/s.json a.ray out.png");
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.errors, Catch::StartsWith("trace: error: cannot write 'no/s.json': "));
  CHECK(!std::filesystem::exists(folder.path() / "out.png"));
}

TEST_CASE("the text names what was spared, which lights were culled and that everything was modelled") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray",
             "SBT-raytracer 1.0\npoint_light { position = (0,0,3); color = (0,0,0); }\n"
             "sphere { material = { diffuse = (1,0,0); } }\n");
  const std::string needed = run_trace(folder.path(), "--stats -w 4 a.ray out.png").errors;
  CHECK_THAT(needed, Catch::Contains("left out light 1 of 1 (black)\n") &&
                         Catch::Contains("decoded  0 by libpng, 0 by stb, 0 by OpenImageIO\n") &&
                         Catch::Contains("0 faint rays\n"));
  const std::string all = run_trace(folder.path(), "--stats --model-everything -w 4 a.ray out.png").errors;
  CHECK_THAT(all, Catch::Contains("modelled everything, needed or not\n") && !Catch::Contains("(black)"));
}

TEST_CASE("the least contribution is a number from 0 to 1") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray",
             "SBT-raytracer 1.0\ncamera { position = (0,0,4); }\n"
             "square { material = { reflective = (0.5,0.5,0.5); } }\n");
  for (const char* wrong : {"-0.1", "1.5", "much"}) {
    const Outcome outcome =
        run_trace(folder.path(), std::string("-w 4 --least-contribution ") + wrong + " a.ray out.png");
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.errors, Catch::StartsWith("trace: error: --least-contribution: "));
  }
  const auto rays = [&](const char* least) {
    return run_trace(folder.path(),
                     std::string("--stats -w 4 --least-contribution ") + least + " a.ray out.png")
        .errors;
  };
  CHECK_THAT(rays("0.5"), !Catch::Contains(" 0 reflected") && Catch::Contains("; 0 faint rays"));
  CHECK_THAT(rays("0.51"), Catch::Contains(" 0 reflected") && !Catch::Contains("; 0 faint rays"));
}

}  // namespace trace::test
