// Files are told apart by their content.
#include "batch/content_hash.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {

TEST_CASE("a file's hash is that of its content") {
  const TemporaryFolder folder;
  const std::string text(200'000, 'x');
  write_text(folder / "a", text);
  CHECK(file_hash(folder / "a") == content_hash(text));
  CHECK(content_hash(text) != content_hash(text + "x"));
  // The value that the authors of XXH3 publish for no bytes at all.
  CHECK(content_hash("") == "99aa06d3014798d86001c324468d497f");
}

TEST_CASE("a file that is not there has no hash") {
  const TemporaryFolder folder;
  CHECK(!file_hash(folder / "none"));
}

TEST_CASE("a folder's hash is that of the names in it") {
  const TemporaryFolder folder;
  const auto empty = file_hash(folder.path());
  CHECK(empty);
  write_text(folder / "a", "1");
  const auto one = file_hash(folder.path());
  CHECK(one != empty);
  write_text(folder / "a", "2");
  CHECK(file_hash(folder.path()) == one);
}

TEST_CASE("a file is hashed once") {
  const TemporaryFolder folder;
  write_text(folder / "a", "1");
  FileHashes hashes;
  const auto before = hashes.of(folder / "a");
  write_text(folder / "a", "2");
  CHECK(hashes.of(folder / "a") == before);
  CHECK(FileHashes().of(folder / "a") != before);
}

}  // namespace trace::test
