// What a finished scene left is there whatever happens afterwards.
#include "batch/journal.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {

TEST_CASE("a journal gives back what was appended, oldest first") {
  const TemporaryFolder folder;
  {
    Journal journal(folder / "j");
    CHECK(journal.earlier().empty());
    journal.append({{"scene", "a"}});
    journal.append({{"scene", "b\n\"\xff"}});
  }
  const Journal journal(folder / "j");
  REQUIRE(journal.earlier().size() == 2);
  CHECK(journal.earlier()[0].at("scene") == "a");
  CHECK(journal.earlier()[1].at("scene") == "b\n\"\xef\xbf\xbd");
}

TEST_CASE("half a line at the end of a journal is dropped, and the next one stands alone") {
  const TemporaryFolder folder;
  write_text(folder / "j", "{\"scene\":\"a\"}\n{\"scene\":\"b");
  { Journal(folder / "j").append({{"scene", "c"}}); }
  CHECK(read_text(folder / "j") == "{\"scene\":\"a\"}\n{\"scene\":\"c\"}\n");
}

TEST_CASE("lines of a journal that are no objects are passed over") {
  const TemporaryFolder folder;
  write_text(folder / "j", "nonsense\n[1]\n\n{\"scene\":\"a\"}\n7\n");
  const Journal journal(folder / "j");
  REQUIRE(journal.earlier().size() == 1);
  CHECK(journal.earlier()[0].at("scene") == "a");
}

TEST_CASE("two batches cannot write to one journal") {
  const TemporaryFolder folder;
  const Journal first(folder / "j");
  // Locks are between processes.
  const pid_t other = fork();
  if (other == 0) {
    try {
      const Journal second(folder / "j");
    } catch (const JournalError& e) {
      const bool told = std::string(e.what()) ==
                        "cannot write '" + (folder / "j").string() + "': another batch is writing to it";
      _exit(told ? 7 : 8);
    }
    _exit(9);
  }
  int status = 0;
  REQUIRE(waitpid(other, &status, 0) == other);
  CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("a journal that cannot be opened is told with its reason") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(Journal(folder / "none/j"),
                    "cannot write '" + (folder / "none/j").string() + "': no such file or directory");
}

}  // namespace trace::test
