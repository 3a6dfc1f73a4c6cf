// The settings file: every key, and every way it can be wrong.
#include <catch2/catch.hpp>

#include "loading/settings_file.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

struct Read {
  TemporaryFolder folder;
  SettingsFile file;
  explicit Read(const std::string& text) {
    const auto path = folder.path() / "s.json";
    write_text(path, text);
    file = read_settings(path.string());
    // The folder's name differs from run to run.
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at; (at = file.messages.find(prefix)) != std::string::npos;) {
      file.messages.erase(at, prefix.size());
    }
  }
};

}  // namespace

TEST_CASE("every key of the settings file sets its option") {
  const Read read(R"({"size": 64, "recursion_depth": 3, "threads": 2, "shadows": false, "smoothshade": false,
    "backface_culling": false, "internal_reflection": false, "backface_specular": true, "anti_alias": true,
    "supersamples": 4, "aa_threshold": 20, "threshold": 7.5, "blocksize": 8, "kdtree": false, "tree_depth": 20,
    "leaf_size": 5, "filter_width": 1, "light_samples": 6, "transmissive_shadows": "none"})");
  CHECK(read.file.valid);
  CHECK(read.file.messages.empty());
  RenderOptions options;
  read.file.apply(options);
  CHECK(options.width == 64);
  CHECK(options.depth == 3);
  CHECK(options.threads == 2);
  CHECK(!options.shading.shadows);
  CHECK(!options.shading.smooth_shading);
  CHECK(!options.shading.backface_culling);
  CHECK(!options.shading.internal_reflection);
  CHECK(options.shading.backface_specular);
  CHECK(options.antialiasing.enabled);
  CHECK(options.antialiasing.supersamples == 4);
  CHECK(options.antialiasing.threshold == 20);
  CHECK(options.blocks.threshold == 7.5);
  CHECK(options.blocks.size == 8);
  CHECK(options.shading.light_samples == 6);
  CHECK(options.shading.transmissive_shadows == TransmissiveShadows::none);
}

TEST_CASE("what the settings file does not give stays") {
  const Read read("{}");
  CHECK(read.file.valid);
  RenderOptions options;
  options.width = 77;
  options.depth = 9;
  read.file.apply(options);
  CHECK(options.width == 77);
  CHECK(options.depth == 9);
  CHECK(options.shading.shadows);
  CHECK(!options.antialiasing.enabled);
}

TEST_CASE("a setting of the wrong type is an error at its value") {
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{"{\"shadows\": 1}",
        "s.json:1:13: error: 'shadows' takes true or false\n{\"shadows\": 1}\n            ^\n"},
       {"{\n  \"size\": \"big\"\n}",
        "s.json:2:11: error: 'size' takes a whole number from 1 to 65536\n  \"size\": \"big\"\n          "
        "^~~~~\n"},
       {"{\"size\": 0}",
        "s.json:1:10: error: 'size' takes a whole number from 1 to 65536\n{\"size\": 0}\n         ^\n"},
       {"{\"size\": 1.5}",
        "s.json:1:10: error: 'size' takes a whole number from 1 to 65536\n{\"size\": 1.5}\n         ^~~\n"},
       {"{\"threads\": 0}",
        "s.json:1:13: error: 'threads' takes a whole number from 1 to 1024\n{\"threads\": 0}\n            "
        "^\n"},
       {"{\"threshold\": [1]}",
        "s.json:1:15: error: 'threshold' takes a number that is not negative\n{\"threshold\": [1]}\n"
        "              ^~~\n"},
       {"{\"transmissive_shadows\": true}",
        "s.json:1:26: error: 'transmissive_shadows' takes \"distance\", \"surface\" or \"none\"\n"
        "{\"transmissive_shadows\": true}\n                         ^~~~\n"},
       {"{\"anti_alias\": null}",
        "s.json:1:16: error: 'anti_alias' takes true or false\n{\"anti_alias\": null}\n               "
        "^~~~\n"}}));
  const Read read(text);
  CHECK(!read.file.valid);
  CHECK(read.file.messages == message);
}

TEST_CASE("text that is no JSON object is an error at its place") {
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{"{\"size\": 64", "the JSON text ends too early"},
       {"", "the JSON text ends too early"},
       {"{size: 64}", "s.json:1:2: error: this is not valid JSON"},
       {"{\"size\": 64,}", "s.json:1:13: error: this is not valid JSON"},
       {"[]", "s.json:1:1: error: a settings file holds one object: { \"key\": value, ... }"},
       {"7", "s.json:1:1: error: a settings file holds one object: { \"key\": value, ... }"}}));
  INFO(text);
  const Read read(text);
  CHECK(!read.file.valid);
  CHECK_THAT(read.file.messages, Catch::Contains(message));
}

TEST_CASE("an unknown setting is a warning with the nearest key") {
  const Read read("{\"anti_alais\": true, \"size\": 5}");
  CHECK(read.file.valid);
  CHECK(read.file.size == 5);
  CHECK(read.file.messages ==
        "s.json:1:2: warning: unknown setting 'anti_alais' has no effect\n"
        "{\"anti_alais\": true, \"size\": 5}\n"
        " ^~~~~~~~~~~~\n"
        "s.json:1:2: note: did you mean 'anti_alias'?\n");
}

TEST_CASE("what is inside an unknown setting is passed over") {
  const Read read("{\"mine\": {\"size\": 9, \"shadows\": [1, {\"shadows\": 2}]}, \"recursion_depth\": 4}");
  CHECK(read.file.valid);
  CHECK(!read.file.size);
  CHECK(read.file.recursion_depth == 4);
}

TEST_CASE("settings win over flags and the program says so") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray", "SBT-raytracer 1.0\n");
  write_text(folder.path() / "s.json", "{\"size\": 6, \"recursion_depth\": 2}");
  const Outcome outcome = run_trace(folder.path(), "-w 9 -r 2 -j s.json a.ray out.png");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors == "trace: note: \"size\": 6 in s.json wins over -w 9\n");
  CHECK(read_image(folder.path() / "out.png").width == 6);
  CHECK(run_trace(folder.path(), "-q -w 9 -j s.json a.ray out.png").errors.empty());
}

TEST_CASE("a settings file that is missing or wrong is exit status 1 and no picture") {
  const TemporaryFolder folder;
  write_text(folder.path() / "a.ray", "SBT-raytracer 1.0\n");
  const Outcome missing = run_trace(folder.path(), "-j no.json a.ray out.png");
  CHECK(missing.status == 1);
  CHECK(missing.errors == "trace: error: cannot read 'no.json': no such file\n");
  write_text(folder.path() / "s.json", "{\"shadows\": \"no\"}");
  const Outcome wrong = run_trace(folder.path(), "-q -j s.json a.ray out.png");
  CHECK(wrong.status == 1);
  CHECK_THAT(wrong.errors, Catch::StartsWith("s.json:1:13: error: 'shadows' takes true or false\n"));
  CHECK(!std::filesystem::exists(folder.path() / "out.png"));
}

}  // namespace trace::test
