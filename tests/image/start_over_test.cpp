#include "image/start_over.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "picture_files.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("files can be read again, and so can those that are not there; pipes and standard input cannot") {
  const TemporaryFolder directory;
  put(directory / "a", Bytes{1});
  REQUIRE(mkfifo((directory / "pipe").c_str(), 0600) == 0);
  const std::string file = directory / "a", pipe = directory / "pipe", missing = directory / "b";
  CHECK(can_be_read_again({}));
  CHECK(can_be_read_again({file, "", missing}));
  CHECK_FALSE(can_be_read_again({file, pipe}));
  CHECK_FALSE(can_be_read_again({"-", file}));
  CHECK_FALSE(can_be_read_again({"/dev/null"}));
}
