// batch.json: what it says of which scene, and what is wrong with it.
#include "batch/batch_file.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

struct Read {
  TemporaryFolder folder;
  std::string messages;
  bool valid = true;
  std::optional<BatchFile> file;

  explicit Read(std::string_view text) {
    write_text(folder / "aa.json", "{\"anti_alias\": true}");
    write_text(folder / "batch.json", text);
    file = BatchFile::read(folder / "batch.json", messages, valid);
    // The folder's name differs from run to run.
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at; (at = messages.find(prefix)) != messages.npos;) messages.erase(at, prefix.size());
  }
};

}  // namespace

TEST_CASE("batch.json gives options to the scenes that match, what is later winning") {
  const Read read(R"({
    "scenes": {"glass/*": {"depth": 10, "width": 64},
               "glass/deep.ray": {"depth": 32, "timeout": 2.5, "memory": 100, "cubemap": "sky/posx.png"}},
    "default": {"depth": 3, "settings": "aa.json"}, "exclude": ["draft*"]})");
  CHECK(read.messages.empty());
  CHECK(read.valid);
  REQUIRE(read.file);
  const SceneOptions plain = read.file->of("plain.ray");
  CHECK(plain.depth == 3);
  CHECK(!plain.width);
  REQUIRE(plain.settings.size() == 1);
  CHECK(plain.settings[0].anti_alias == true);
  CHECK(read.file->of("glass/any.ray").depth == 10);
  const SceneOptions deep = read.file->of("glass/deep.ray");
  CHECK(deep.depth == 32);
  CHECK(deep.width == 64);
  CHECK(deep.timeout == 2.5);
  CHECK(deep.memory == 100);
  CHECK(deep.cube_map == (read.folder / "sky/posx.png").string());
  CHECK(read.file->exclude() == std::vector<std::string>{"draft*"});
}

TEST_CASE("a folder without batch.json has no options") {
  const TemporaryFolder folder;
  std::string messages;
  bool valid = true;
  CHECK(!BatchFile::read(folder / "batch.json", messages, valid));
  CHECK(valid);
  CHECK(messages.empty());
}

TEST_CASE("what is wrong with batch.json is told at its place") {
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{R"({"scenes": {"*": {"dept": 3}}})",
        "batch.json:1:19: error: unknown option of a scene 'dept'\n"
        "{\"scenes\": {\"*\": {\"dept\": 3}}}\n"
        "                  ^~~~~~\n"
        "batch.json:1:19: note: did you mean 'depth'?\n"},
       {R"({"default": {"width": 0}})",
        "batch.json:1:23: error: 'width' takes a whole number from 1 to 65536\n"
        "{\"default\": {\"width\": 0}}\n"
        "                      ^\n"},
       {R"({"scenes": {"a": 5}})",
        "batch.json:1:18: error: 'a' takes an object: { ... }\n"
        "{\"scenes\": {\"a\": 5}}\n"
        "                 ^\n"},
       {R"({"default": {"timeout": -1}})",
        "batch.json:1:25: error: 'timeout' takes a number from 0.001 to 1000000\n"
        "{\"default\": {\"timeout\": -1}}\n"
        "                        ^~\n"},
       {R"({"exclude": "x"})",
        "batch.json:1:13: error: 'exclude' takes a list of patterns in quotes\n"
        "{\"exclude\": \"x\"}\n"
        "            ^~~\n"},
       {"[]",
        "batch.json:1:1: error: batch.json holds one object: { \"default\": ..., \"scenes\": ... }\n"
        "[]\n"
        "^\n"},
       {R"({"default": {"settings": "none.json"}})", "trace: error: cannot read 'none.json': no such file\n"},
       {R"({"default": {"settings": {"shadows": 1}}})",
        "batch.json:1:38: error: 'shadows' takes true or false\n"
        "{\"default\": {\"settings\": {\"shadows\": 1}}}\n"
        "                                     ^\n"}}));
  const Read read(text);
  CHECK(!read.valid);
  CHECK(read.messages == message);
}

}  // namespace trace::test
