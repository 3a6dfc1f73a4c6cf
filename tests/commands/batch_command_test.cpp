// `trace batch`: every scene is done or told of, whatever the others do.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "image/image.hpp"
#include "tests/support/batch_folder.hpp"

namespace trace::test {

TEST_CASE("a batch draws what single renders draw, in folders like those of the scenes") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  batch.add_scene("deep/er/b.ray", sphere);
  const Outcome outcome = batch.run("scenes -o out -w 40");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.output, Catch::Matches("2 scenes in [0-9.]+ s: 2 rendered, 0 failed\n"));
  for (const std::string name : {"a", "deep/er/b"}) {
    REQUIRE(run_trace(batch.path(), "-w 40 scenes/" + name + ".ray single.png").status == 0);
    CHECK(read_text(batch / ("out/" + name + ".png")) == read_text(batch / "single.png"));
  }
}

TEST_CASE("scenes that fail are told of and the others are done") {
  const BatchFolder batch;
  for (int i = 0; i < 10; ++i) batch.add_scene("good" + std::to_string(i) + ".ray");
  batch.add_scene("syntax.ray", "shpere {}");
  batch.add_scene("texture.ray", "sphere { material = { diffuse = map(\"none.png\"); } }");
  batch.add_scene("slow.ray", endless_objects());
  const Outcome outcome = batch.run("scenes -o out -w 64 -r 1000 --timeout 1");
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.output, Catch::Matches("13 scenes in [0-9.]+ s: 10 rendered, 3 failed\n"));
  CHECK_THAT(outcome.errors, Catch::Contains("scenes/syntax.ray:3:1: error: unknown word 'shpere'"));
  CHECK_THAT(
      outcome.errors,
      Catch::Contains("scenes/texture.ray:3:33: error: cannot read texture 'none.png': no such file\n"));
  CHECK_THAT(outcome.errors,
             Catch::Contains("scenes/slow.ray: error: not done after 1 s, the limit of time for "
                             "one scene (--timeout)\n"));
  CHECK(batch.outcome("slow.ray") == "timeout");
  CHECK(batch.outcome("syntax.ray") == "failed");
  CHECK(batch.names("out").size() == 12);  // ten pictures, results.json and results.jsonl
}

TEST_CASE("a scene that needs too much memory is told of and leaves no picture") {
  const BatchFolder batch;
  batch.add_scene("big.ray");
  batch.add_scene("small.ray");
  write_text(batch / "scenes/batch.json", R"({"scenes": {"big.ray": {"width": 16000, "memory": 200}}})");
  const Outcome outcome = batch.run("scenes -o out -w 20");
  CHECK(outcome.status == 3);
  CHECK(batch.outcome("big.ray") == "memory");
  CHECK_THAT(outcome.errors,
             Catch::Contains("scenes/big.ray: error: needs more than 200 MiB, the limit of memory "
                             "for one scene (--memory)\n"));
  CHECK(batch.outcome("small.ray") == "rendered");
  CHECK(!std::filesystem::exists(batch / "out/big.png"));
}

TEST_CASE("the second run of a batch does nothing where nothing has changed") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  batch.add_scene("b.ray");
  REQUIRE(batch.run("scenes -o out -w 20").status == 0);
  const Outcome again = batch.run("scenes -o out -w 20");
  CHECK(again.status == 0);
  CHECK(again.errors.empty());
  CHECK_THAT(again.output, Catch::EndsWith("2 rendered, 0 failed (2 done before)\n"));
  CHECK_THAT(batch.run("scenes -o out -w 20 --fresh").output, Catch::EndsWith("2 rendered, 0 failed\n"));
}

TEST_CASE("a batch does again what a change of scene, texture, options or picture concerns") {
  const BatchFolder batch;
  batch.add_scene("a.ray", "sphere { material = { diffuse = map(\"t.png\"); } }");
  batch.add_scene("b.ray");
  write_image(batch / "scenes/t.png", {1, 1, {10, 20, 30}});
  REQUIRE(batch.run("scenes -o out -w 20").status == 0);
  const auto done_again = [&](const std::string& options = "") {
    return batch.run("scenes -o out -w 20 " + options).errors;
  };
  write_image(batch / "scenes/t.png", {1, 1, {40, 20, 30}});
  CHECK_THAT(done_again(), Catch::Matches(R"(\[1/1\] a.ray: rendered, [0-9]+ ms\n)"));
  batch.add_scene("b.ray", sphere);
  CHECK_THAT(done_again(), Catch::Matches(R"(\[1/1\] b.ray: rendered, [0-9]+ ms\n)"));
  std::filesystem::remove(batch / "out/b.png");
  CHECK_THAT(done_again(), Catch::Contains("[1/1] b.ray: rendered"));
  write_text(batch / "out/a.png", "damaged");
  CHECK_THAT(done_again(), Catch::Contains("[1/1] a.ray: rendered"));
  CHECK(read_image(batch / "out/a.png").width == 20);
  CHECK_THAT(done_again("-r 3"), Catch::Contains("[2/2]"));
  CHECK(done_again("-r 3").empty());
}

TEST_CASE("a texture that appears where one was missing is noticed") {
  const BatchFolder batch;
  batch.add_scene("a.ray", "sphere { material = { shininess = map(\"t.png\"); } }");
  write_image(batch / "t.png", {1, 1, {10, 20, 30}});  // in the working folder, the second place
  REQUIRE(batch.run("scenes -o out -w 20").status == 0);
  REQUIRE(batch.run("scenes -o out -w 20").errors.empty());
  write_image(batch / "scenes/t.png", {1, 1, {200, 20, 30}});
  CHECK_THAT(batch.run("scenes -o out -w 20").errors, Catch::Contains("[1/1] a.ray: rendered"));
}

TEST_CASE("a batch that was killed goes on where it stopped, and its results are those of one that was not") {
  const BatchFolder batch;
  for (int i = 0; i < 30; ++i) batch.add_scene("s" + std::to_string(i) + ".ray", sphere + box);
  batch.shell("timeout -s KILL 0.4 $TRACE batch scenes -o out -w 400 -t 1");
  const std::size_t done_before = batch.lines("out/results.jsonl");
  const Outcome outcome = batch.run("scenes -o out -w 400 -t 1");
  CHECK(outcome.status == 0);
  if (done_before > 0) {
    CHECK_THAT(outcome.output,
               Catch::EndsWith("30 rendered, 0 failed (" + std::to_string(done_before) + " done before)\n"));
  }
  CHECK(batch.lines("out/results.jsonl") == 30);
  REQUIRE(batch.run("scenes -o whole -w 400 -t 1").status == 0);
  CHECK(batch.results_without_times("out") == batch.results_without_times("whole"));
}

TEST_CASE("Ctrl-C leaves valid results of what is done") {
  const BatchFolder batch;
  for (int i = 0; i < 5; ++i) batch.add_scene("s" + std::to_string(i) + ".ray");
  batch.add_scene("z_slow.ray", endless_objects());
  const int status = batch.shell(
      "timeout -s INT --preserve-status 3 $TRACE batch scenes -o out -w 64 -r 1000 -t 2 --report out/r.html");
  CHECK(status == 130);
  const auto results = batch.results("out");
  CHECK(results.at("interrupted") == true);
  CHECK(results.at("results").size() == 5);
  CHECK_THAT(read_text(batch / "out/r.html"), Catch::Contains("</html>"));
}

TEST_CASE("batch.json beside the scenes gives options to each") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  batch.add_scene("small/b.ray");
  batch.add_scene("small/draft.ray");
  write_text(batch / "scenes/batch.json",
             R"({"default": {"width": 30}, "scenes": {"small/*": {"width": 20}}})");
  write_text(batch / "scenes/small/batch.json", R"({"exclude": ["draft*"]})");
  REQUIRE(batch.run("scenes -o out -w 50").status == 0);
  CHECK(read_image(batch / "out/a.png").width == 30);
  CHECK(read_image(batch / "out/small/b.png").width == 20);
  CHECK(!std::filesystem::exists(batch / "out/small/draft.png"));
}

TEST_CASE("a batch that cannot begin says why and is status 4") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  const auto [arguments, message] = GENERATE(table<std::string, std::string>(
      {{"none -o out", "trace: error: 'none' is not a folder\n"},
       {"scenes -o out --solutions none", "trace: error: 'none' is not a folder\n"},
       {"scenes -o out --include 'x*'", "trace: error: no scenes in 'scenes'\n"},
       {"scenes", "trace: error: --output is required\nRun 'trace batch --help' for how to use it.\n"},
       {"scenes -o out --exec 'p {scene}'",
        "trace: error: --exec 'p {scene}': the command needs the word {out}\n"},
       {"scenes -o out --exec 'p {scene} {out} {dept}'",
        "trace: error: --exec 'p {scene} {out} {dept}': unknown placeholder {dept}: there are {scene}, "
        "{out}, "
        "{depth}, {width}\n"}}));
  INFO(arguments);
  const Outcome outcome = batch.run(arguments);
  CHECK(outcome.status == 4);
  CHECK(outcome.errors == message);
  CHECK(outcome.output.empty());
}

TEST_CASE("a picture is compared with the solution of its name, and the worst is the status") {
  const BatchFolder batch;
  batch.add_scene("a.ray", sphere);
  batch.add_scene("b.ray", sphere);
  batch.add_scene("c.ray", sphere);
  REQUIRE(batch.run("scenes -o sol -w 40").status == 0);
  std::filesystem::remove(batch / "sol/c.png");
  CHECK(batch.run("scenes -o out -w 40 --solutions sol").status == 0);
  const Outcome same = batch.run("scenes -o out -w 40 --solutions sol");
  CHECK_THAT(same.output, Catch::EndsWith("\n2 identical, 1 without a solution\n"));
  batch.add_scene("b.ray", box);
  const Outcome beyond = batch.run("scenes -o out -w 40 --solutions sol");
  CHECK(beyond.status == 1);
  CHECK(batch.verdict("b.ray") == "beyond");
  CHECK(std::filesystem::exists(batch / "out/b.heat.png"));
  CHECK(!std::filesystem::exists(batch / "out/a.heat.png"));
}

TEST_CASE("where only the solution has changed nothing is drawn, but compared") {
  const BatchFolder batch;
  batch.add_scene("a.ray", sphere);
  REQUIRE(batch.run("scenes -o sol -w 40").status == 0);
  REQUIRE(batch.run("scenes -o out -w 40 --solutions sol").status == 0);
  const auto drawn = std::filesystem::last_write_time(batch / "out/a.png");
  write_image(batch / "sol/a.png", {40, 40, std::vector<std::uint8_t>(4800, 255)});
  CHECK(batch.run("scenes -o out -w 40 --solutions sol").status == 1);
  CHECK(batch.verdict("a.ray") == "beyond");
  CHECK(std::filesystem::last_write_time(batch / "out/a.png") == drawn);
}

TEST_CASE("a heat map that cannot be written does not hide the verdict") {
  const BatchFolder batch;
  batch.add_scene("a.ray", sphere);
  REQUIRE(batch.run("scenes -o sol -w 40").status == 0);
  batch.add_scene("a.ray", box);
  std::filesystem::create_directories(batch / "out/a.heat.png/x");
  for (int round = 0; round < 2; ++round) {
    const Outcome outcome = batch.run("scenes -o out -w 40 --solutions sol");
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.errors,
               Catch::Contains("trace: error: cannot write 'out/a.heat.png': is a directory\n"));
    CHECK(batch.verdict("a.ray") == "beyond");
  }
}

TEST_CASE("a face of the cube map that appears later is noticed") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  std::filesystem::create_directories(batch / "sky");
  for (const char* face : {"posx", "negx", "posy", "posz", "negz"})
    write_image(batch / (std::string("sky/") + face + ".png"), {1, 1, {10, 20, 30}});
  const std::string command = "scenes -o out -w 20 -c sky/posx.png";
  CHECK_THAT(batch.run(command).errors, Catch::Contains("no cube map: the folder 'sky' has no negy face"));
  CHECK(batch.run(command).errors.empty());
  write_image(batch / "sky/negy.png", {1, 1, {10, 20, 30}});
  CHECK_THAT(batch.run(command).errors, Catch::Matches(R"(\[1/1\] a.ray: rendered, [0-9]+ ms\n)"));
}

TEST_CASE("comparing does not count against a scene's limits") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  REQUIRE(batch.run("scenes -o sol -w 1500").status == 0);
  REQUIRE(batch.run("scenes -o out -w 1500").status == 0);
  CHECK(batch.run("scenes -o out -w 1500 --solutions sol --timeout 0.001 --memory 1").status == 0);
  CHECK(batch.verdict("a.ray") == "identical");
}

TEST_CASE("a batch does not write over its solutions or textures") {
  const BatchFolder batch;
  batch.add_scene("a.ray", "sphere { material = { diffuse = map(\"a.png\"); } }");
  write_image(batch / "scenes/a.png", {1, 1, {10, 20, 30}});
  const Outcome texture = batch.run("scenes -o scenes -w 20");
  CHECK(texture.status == 3);
  CHECK(read_image(batch / "scenes/a.png").width == 1);
  CHECK_THAT(texture.errors,
             Catch::Contains("scenes/a.ray: error: its picture would replace 'scenes/a.png', which "
                             "the scene uses\n"));
  const Outcome solution = batch.run("scenes -o scenes -w 20 --solutions scenes");
  CHECK(solution.status == 4);
  CHECK(solution.errors ==
        "trace: error: the picture of 'a.ray' would replace its solution 'scenes/a.png'\n");
}

TEST_CASE("solutions of which none has the name of a scene are refused") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  std::filesystem::create_directories(batch / "sol");
  const Outcome outcome = batch.run("scenes -o out -w 20 --solutions sol");
  CHECK(outcome.status == 4);
  CHECK(outcome.errors == "trace: error: no picture in 'sol' has the name of a scene\n");
}

TEST_CASE("two scenes that would be drawn to one picture are refused") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  batch.add_scene("a.heat.ray");
  REQUIRE(batch.run("scenes -o sol -w 20").status == 0);
  const Outcome outcome = batch.run("scenes -o out -w 20 --solutions sol");
  CHECK(outcome.status == 4);
  CHECK(outcome.errors == "trace: error: 'a.heat.ray' and 'a.ray' would both be drawn to 'out/a.heat.png'\n");
}

TEST_CASE("a batch whose messages nobody can see is done all the same") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  CHECK(batch.run("scenes -o out -w 20 2>/dev/full >/dev/null").status == 0);
  CHECK(batch.results("out").at("results").size() == 1);
}

TEST_CASE("results that cannot be written are told before any work is done") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  const Outcome outcome = batch.run("scenes -o out -w 20 --csv none/x.csv");
  CHECK(outcome.status == 3);
  CHECK(outcome.errors == "trace: error: cannot write 'none/x.csv': no such directory\n");
  CHECK(!std::filesystem::exists(batch / "out/a.png"));
}

TEST_CASE("a journal of another kind does no harm") {
  const BatchFolder batch;
  batch.add_scene("a.ray");
  std::filesystem::create_directories(batch / "out");
  write_text(batch / "out/results.jsonl", "{\"scene\":\"a.ray\",\"renderer\":\"trace\",\"seconds\":null}\n");
  CHECK(batch.run("scenes -o out -w 20").status == 0);
}

TEST_CASE("control characters in names do not reach the terminal") {
  const BatchFolder batch;
  batch.add_scene("a\x1b[31m.ray");
  CHECK_THAT(batch.run("scenes -o out -w 20").errors, Catch::StartsWith("[1/1] a\\x1b[31m.ray: rendered"));
}

}  // namespace trace::test
