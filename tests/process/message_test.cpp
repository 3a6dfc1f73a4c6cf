#include "process/message.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "process/pipe.hpp"

namespace trace::test {
namespace {

struct Connection {
  Connection() {
    std::array<int, 2> ends{};
    REQUIRE(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0);
    here = Descriptor(ends[0]);
    there = Descriptor(ends[1]);
    must_not_block(here);
    must_not_block(there);
  }
  Descriptor here, there;
};

Message message(std::string body, std::uint64_t number = 0) {
  Message all;
  all.kind = MessageKind::answer;
  all.number = number;
  all.body = std::move(body);
  return all;
}

}  // namespace

TEST_CASE("messages arrive whole and in order, however little the socket takes at a time") {
  Connection connection;
  MessageWriter writer;
  MessageReader reader;
  const std::string large(3'000'000, 'x');
  writer.put(message("one", 1));
  writer.put(message(large, 2));
  writer.put(message("", 3));
  std::vector<Message> arrived;
  for (int turn = 0; turn < 10'000 && arrived.size() < 3; ++turn) {
    REQUIRE(writer.flush(connection.here.get()));
    while (auto next = reader.read(connection.there.get())) arrived.push_back(std::move(*next));
  }
  REQUIRE(arrived.size() == 3);
  CHECK(arrived[0].body == "one");
  CHECK(arrived[1].body == large);
  CHECK(arrived[2].body.empty());
  CHECK(arrived[2].number == 3);
  CHECK_FALSE(writer.pending());
  CHECK_FALSE(reader.closed());
}

TEST_CASE("a descriptor goes with its own message") {
  Connection connection;
  Pipe pipe;
  MessageWriter writer;
  writer.put(message("without"));
  writer.put(message("with"));
  Message with = message("its own");
  with.descriptor = std::move(pipe.write);
  writer.put(std::move(with));
  writer.put(message("without again"));
  REQUIRE(writer.flush(connection.here.get()));
  MessageReader reader;
  CHECK_FALSE(reader.read(connection.there.get())->descriptor);
  CHECK_FALSE(reader.read(connection.there.get())->descriptor);
  const Descriptor received = std::move(reader.read(connection.there.get())->descriptor);
  CHECK_FALSE(reader.read(connection.there.get())->descriptor);
  REQUIRE(received);
  REQUIRE(write(received.get(), "x", 1) == 1);
  char byte = 0;
  CHECK(read(pipe.read.get(), &byte, 1) == 1);
}

TEST_CASE(
    "an end of the connection in the middle of a message is noticed, as are bytes that are no message") {
  Connection connection;
  const std::string part = GENERATE(std::string(), std::string("short"), std::string(100, '\xff'));
  REQUIRE(write(connection.here.get(), part.data(), part.size()) == ssize_t(part.size()));
  connection.here.reset();
  MessageReader reader;
  CHECK_FALSE(reader.read(connection.there.get()));
  CHECK(reader.closed());
}

}  // namespace trace::test
