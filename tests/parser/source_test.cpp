// Files and the places in them.
#include "parser/source.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/support/temporary_folder.hpp"

using namespace trace::parser;

using trace::test::TemporaryFolder;

namespace {

std::string write(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  trace::test::write_text(folder / name, text);
  return (folder / name).string();
}

}  // namespace

TEST_CASE("a file is read byte for byte, whatever its size, and NUL bytes follow it") {
  const std::size_t size = GENERATE(0u, 1u, 4080u, 4095u, 4096u, 4097u, 8192u, 100000u);
  const TemporaryFolder folder;
  std::string text;
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(i * 7 % 251);
  const Source source = Source::from_file(write(folder, "a.ray", text));
  CHECK(source.text() == text);
  CHECK(source.directory() == folder.path().string());
  for (std::size_t i = 0; i < text_padding; ++i) CHECK(source.text().data()[size + i] == '\0');
}

TEST_CASE("a file that cannot be read says why") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(Source::from_file("nowhere.ray"), "cannot read 'nowhere.ray': no such file");
  CHECK_THROWS_WITH(Source::from_file(folder.path().string()),
                    "cannot read '" + folder.path().string() + "': it is a directory");
}

TEST_CASE("a text knows its name and stands in the current folder") {
  const Source source = Source::from_text("words", "abc");
  CHECK(source.name() == "words");
  CHECK(source.directory() == ".");
  CHECK(source.text() == "abc");
}

TEST_CASE("lines end at LF, CR LF and CR, and count from 1") {
  const Source source = Source::from_text("t", "ab\ncd\r\nef\rgh");
  const auto at = [&](std::uint32_t offset) {
    const Position position = source.position(offset);
    return std::pair(position.line, position.column);
  };
  CHECK(at(0) == std::pair<std::uint64_t, std::uint64_t>(1, 1));
  CHECK(at(2) == std::pair<std::uint64_t, std::uint64_t>(1, 3));
  CHECK(at(3) == std::pair<std::uint64_t, std::uint64_t>(2, 1));
  CHECK(at(6) == std::pair<std::uint64_t, std::uint64_t>(2, 4));
  CHECK(at(7) == std::pair<std::uint64_t, std::uint64_t>(3, 1));
  CHECK(at(10) == std::pair<std::uint64_t, std::uint64_t>(4, 1));
  CHECK(at(12) == std::pair<std::uint64_t, std::uint64_t>(4, 3));
  CHECK(source.line_at(4) == "cd");
  CHECK(source.line_at(6) == "cd");
  CHECK(source.line_at(12) == "gh");
  CHECK(source.line_begin(8) == 7);
}
