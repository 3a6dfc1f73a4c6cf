// `trace diff` of two folders, and the files it writes.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/commands/diff_desk.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

using nlohmann::json;

// One pair of each kind that folders can have.
struct Folders : DiffDesk {
  Folders() {
    put("A/same.png", 7);
    put("B/same.png", 7);
    put("A/simple/close.png", 7);
    put("B/simple/close.png", 7, 8, 8, 8);
    put("A/simple/far.png", 0);
    put("B/simple/far.bmp", 255);
    put("A/small.png", 7);
    put("B/small.png", 7, 4, 4);
    put("A/lost.png", 7);
    put("B/simple/more.png", 7);
  }
  std::vector<std::string> names(const std::string& below) const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / below))
      result.push_back(entry.path().lexically_relative(folder / below).string());
    std::sort(result.begin(), result.end());
    return result;
  }
};

// Folders in one another below `top` until the last's path is too long to be read, with a picture in a
// readable one. (Permissions would not stop a superuser.)
void make_unreadable_folder(const DiffDesk& desk, const std::string& top) {
  const std::string name(200, 'n');
  std::filesystem::path half;
  for (int i = 0; i < 11; ++i) half /= name;
  std::filesystem::create_directories(desk.folder / top / half);
  std::filesystem::create_directories(desk.folder / "half" / half);
  std::filesystem::rename(desk.folder / "half", desk.folder / top / half / "half");
}

}  // namespace

TEST_CASE("a subfolder that cannot be read is told by name: status 3, and the rest is compared") {
  const DiffDesk desk;
  desk.put("A/same.png", 7);
  desk.put("B/same.png", 7);
  make_unreadable_folder(desk, "B/deep");
  const Outcome outcome = desk.diff("A B");
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.errors, Catch::StartsWith("trace: error: cannot read 'B/deep/nnn") &&
                                 Catch::EndsWith("': File name too long\n"));
  CHECK(outcome.output == "identical  same\n1 picture: 1 identical\n");
}

TEST_CASE("links that lead nowhere or in a circle are unreadable, and the rest is compared") {
  const DiffDesk desk;
  for (const std::string name : {"broken", "loop", "same"}) desk.put("A/" + name + ".png", 7);
  desk.put("B/same.png", 7);
  std::filesystem::create_symlink("nowhere.png", desk / "B/broken.png");
  std::filesystem::create_symlink("loop.png", desk / "B/loop.png");
  const Outcome outcome = desk.diff("A B");
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.output, Catch::StartsWith("unreadable  broken  ") &&
                                 Catch::Contains("\nunreadable  loop    ") &&
                                 Catch::EndsWith("3 pictures: 1 identical, 2 unreadable\n"));
}

TEST_CASE("folders are listed by name and counted, missing and extra pictures too: status 3") {
  const Folders desk;
  const Outcome outcome = desk.diff("A B");
  CHECK(outcome.status == 3);
  CHECK(outcome.errors.empty());
  CHECK(outcome.output ==
        "missing           lost          there is none in B\n"
        "identical         same\n"
        "within tolerance  simple/close  RMSE 0.07217, 1.562 % of pixels differ\n"
        "beyond tolerance  simple/far    RMSE 255 is over 0.5; 100 % of the pixels are off by more than 1 "
        "level, "
        "which is over 0.1 %\n"
        "extra             simple/more   there is none in A\n"
        "size differs      small         8 x 8 against 4 x 4\n"
        "6 pictures: 1 identical, 1 within tolerance, 1 beyond tolerance, 1 size differs, 1 missing, 1 "
        "extra\n");
}

TEST_CASE("of folders the worst status counts") {
  const Folders desk;
  std::filesystem::remove(desk / "A/lost.png");
  std::filesystem::remove(desk / "B/simple/more.png");
  CHECK(desk.diff("A B").status == 2);
  std::filesystem::remove(desk / "B/small.png");
  std::filesystem::remove(desk / "A/small.png");
  CHECK(desk.diff("A B").status == 1);
  CHECK(desk.diff("A B --max 255").status == 0);
}

TEST_CASE("folders without pictures are an error, not a success: status 3") {
  const DiffDesk desk;
  std::filesystem::create_directories(desk / "A");
  std::filesystem::create_directories(desk / "B");
  const Outcome outcome = desk.diff("A B");
  CHECK(outcome.status == 3);
  CHECK(outcome.errors == "trace: error: there are no pictures in 'A' and 'B'\n");
}

TEST_CASE("JSON on standard output fits the schema and takes the place of the lines") {
  const Folders desk;
  const Outcome outcome = desk.diff("A B --json -");
  CHECK(outcome.status == 3);
  CHECK(schema_faults("diff-1.schema.json", outcome.output) == "");
  const json document = json::parse(outcome.output);
  CHECK(document["status"] == 3);
  REQUIRE(document["pairs"].size() == 6);
  CHECK(document["pairs"][0]["name"] == "lost");
  CHECK(document["pairs"][0]["verdict"] == "missing");
  CHECK(document["pairs"][3]["test"] == "B/simple/far.bmp");
  CHECK(document["pairs"][3]["measurements"]["root_mean_square"] == 255);
  CHECK(document["pairs"][3]["measurements"]["largest"]["difference"] == 255);
}

TEST_CASE("results go to files beside what is printed") {
  const Folders desk;
  const Outcome outcome = desk.diff("A B --json r.json --csv r.csv --junit r.xml");
  CHECK_THAT(outcome.output, Catch::Contains("6 pictures:"));
  CHECK(json::parse(read_text(desk / "r.json"))["counts"]["extra"] == 1);
  CHECK_THAT(read_text(desk / "r.csv"), Catch::StartsWith("name,reference,test,verdict,reason,"));
  CHECK_THAT(read_text(desk / "r.xml"), Catch::Contains("tests=\"6\" failures=\"2\" errors=\"2\""));
}

TEST_CASE("a result that cannot be written is known before the work: status 3, and nothing is left behind") {
  const Folders desk;
  write_text(desk / "r.csv", "old");
  const Outcome outcome = desk.diff("A B --csv r.csv --json nowhere/r.json");
  CHECK(outcome.status == 3);
  CHECK(outcome.output.empty());
  CHECK(outcome.errors == "trace: error: cannot write 'nowhere/r.json': no such directory\n");
  CHECK(read_text(desk / "r.csv") == "old");
  CHECK(desk.folder.names() == std::vector<std::string>{"A", "B", "r.csv"});
  CHECK(desk.diff("A B >/dev/full").status == 3);
}

TEST_CASE("heat maps of folders have the layout of the folders, and old ones do not stay") {
  const Folders desk;
  CHECK(desk.diff("A B -q -o heat").status == 3);
  CHECK(desk.names("heat") ==
        std::vector<std::string>{"simple", "simple/close.heat.png", "simple/far.heat.png"});
  CHECK(read_image(desk / "heat/simple/far.heat.png").width >= 8);
  desk.put("B/simple/close.png", 7);
  CHECK(desk.diff("A B -q -o heat").status == 3);
  CHECK(!desk.has("heat/simple/close.heat.png"));
  CHECK(desk.has("heat/simple/far.heat.png"));
}

TEST_CASE("a heat map that cannot be written: status 3, with the verdicts all the same") {
  const Folders desk;
  write_text(desk / "file", "");
  const Outcome outcome = desk.diff("A B -o file");
  CHECK(outcome.status == 3);
  CHECK(outcome.errors == "trace: error: cannot write 'file': it is not a folder\n");
  const Outcome type = desk.diff("A/same.png B/simple/far.bmp -o heat.txt");
  CHECK(type.status == 3);
  CHECK_THAT(type.errors, Catch::StartsWith("trace: error: cannot write 'heat.txt': "));
}

TEST_CASE("tolerances.json beside the references counts, unless the command line says otherwise") {
  const DiffDesk desk;
  for (const std::string name : {"x", "y", "deep/z"}) {
    desk.put("A/" + name + ".png", 0);
    desk.put("B/" + name + ".png", 9);
  }
  write_text(desk / "A/tolerances.json", R"({"x": {"max": 9}, "deep/*": {"max": 9, "reason": "deep"}})");
  CHECK(desk.diff("A B").status == 1);
  CHECK_THAT(desk.diff("A B").output,
             Catch::EndsWith("3 pictures: 2 within tolerance, 1 beyond tolerance\n"));
  CHECK_THAT(desk.diff("A B --max 8").output, Catch::EndsWith("3 pictures: 3 beyond tolerance\n"));
  write_text(desk / "t.json", R"({"default": {"rmse": 9}})");
  CHECK(desk.diff("A B --tolerances t.json").status == 0);
  CHECK(desk.diff("A/y.png B/y.png --tolerances A/tolerances.json").status == 1);
  CHECK(desk.diff("A/deep/z.png B/deep/z.png --tolerances A/tolerances.json").status == 0);
  CHECK(desk.diff("A/deep/z.png B/deep/z.png").status == 1);
}

TEST_CASE("an error in a tolerance file has its place: status 3") {
  const DiffDesk desk;
  desk.put("A/x.png", 0);
  desk.put("B/x.png", 0);
  write_text(desk / "A/tolerances.json", "{\"x\": {\"mx\": 9}}");
  const Outcome outcome = desk.diff("A B");
  CHECK(outcome.status == 3);
  CHECK(outcome.output.empty());
  CHECK_THAT(outcome.errors, Catch::StartsWith("A/tolerances.json:1:8: error: unknown tolerance 'mx'\n") &&
                                 Catch::Contains("note: did you mean 'max'?\n"));
  const Outcome missing = desk.diff("A B --tolerances t.json");
  CHECK(missing.status == 3);
  CHECK(missing.errors == "trace: error: cannot read 't.json': no such file\n");
}

TEST_CASE("updating accepts what differs, with the reason, and then it is within tolerance") {
  const Folders desk;
  write_text(desk / "A/tolerances.json", "{\"same\": {\"max\": 1}}");
  const Outcome update = run_trace(desk.folder.path(), "diff A B --update --reason", {"by design"});
  CHECK(update.status == 3);
  CHECK_THAT(update.output, Catch::EndsWith("accepted 1 difference in A/tolerances.json\n"));
  CHECK(read_text(desk / "A/tolerances.json") ==
        "{\n  \"same\": {\"max\":1},\n"
        "  \"simple/far\": {\"rmse\":260.0,\"pixels\":100.0,\"over\":1.0,\"reason\":\"by design\"}\n}\n");
  CHECK_THAT(
      desk.diff("A B").output,
      Catch::EndsWith("6 pictures: 1 identical, 2 within tolerance, 1 size differs, 1 missing, 1 extra\n"));
}

}  // namespace trace::test
