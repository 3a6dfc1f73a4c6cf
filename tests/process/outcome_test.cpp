#include "process/outcome.hpp"

#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>

namespace trace::test {

TEST_CASE("each outcome has its text") {
  using Kind = Outcome::Kind;
  CHECK(text({Kind::answered, 0}) == "done");
  CHECK(text({Kind::exited, 3}) == "exited with status 3");
  CHECK(text({Kind::signalled, SIGSEGV}) == "crashed (segmentation fault)");
  CHECK(text({Kind::signalled, 50}) == "crashed (signal 50)");
  CHECK(text({Kind::timed_out, 0}) == "ran out of time");
  CHECK(text({Kind::out_of_memory, 0}) == "ran out of memory");
  CHECK(text({Kind::could_not_start, EACCES}) == "could not be started: permission denied");
}

TEST_CASE("the last words of a program that got no memory are recognised") {
  CHECK(speaks_of_memory(
      "terminate called after throwing an instance of 'std::bad_alloc'\n  what():  std::bad_alloc"));
  CHECK(speaks_of_memory("Traceback (most recent call last):\nMemoryError\n"));
  CHECK(speaks_of_memory("tail: memory exhausted"));
  CHECK(speaks_of_memory("open: Cannot allocate memory"));
  CHECK_FALSE(speaks_of_memory("used memory: 12 MB"));
  CHECK_FALSE(speaks_of_memory(""));
}

}  // namespace trace::test
