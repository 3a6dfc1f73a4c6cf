// Messages between a supervisor and its workers, over a pair of connected stream sockets. Both ends are the
// same program, so the header is sent as it lies in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "process/descriptor.hpp"

namespace trace {

enum class MessageKind : std::uint32_t {
  job,            // to a worker; `number` is its memory limit
  figures,        // from a worker, before each of the next three: the bytes of a JobFigures
  answer,         // the body is what the work returned
  out_of_memory,  // std::bad_alloc left the work
  failed,         // another exception did; the body is its text
  blob_wanted,    // the body of this and the following is a key
  blob_here,      // with a descriptor
  blob_make,      // "nobody has it: make it yourself"
  blob_made,      // with a descriptor
  blob_not_made
};

struct Message {
  MessageKind kind = MessageKind::job;
  std::uint64_t number = 0;
  std::string body;
  Descriptor descriptor;
};

struct MessageHeader {
  MessageKind kind = MessageKind::job;
  std::uint32_t unused = 0;
  std::uint64_t number = 0;
  std::uint64_t size = 0;  // of the body
};

// Takes messages from a socket, never a byte more than the message it returns.
class MessageReader {
 public:
  // The next message. Nothing where the other end is closed, or, on a non-blocking socket, where no whole
  // message has come yet.
  std::optional<Message> read(int socket);
  bool closed() const { return closed_; }  // or broken: not one of our messages

 private:
  bool read_header(int socket);
  bool read_body(int socket);

  MessageHeader header_;
  std::size_t header_done_ = 0;
  Message message_;
  bool closed_ = false;
};

// Puts messages into a socket. On a blocking one flush() leaves nothing pending.
class MessageWriter {
 public:
  void put(Message message) { pending_.push_back(std::move(message)); }
  bool pending() const { return !pending_.empty(); }
  // False where the other end is gone.
  bool flush(int socket);

 private:
  std::deque<Message> pending_;
  std::size_t done_ = 0;  // of the first one's header and body
};

// One end of a blocking connection, as a worker sees it.
class Channel {
 public:
  explicit Channel(int socket) : socket_(socket) {}  // borrowed
  bool send(Message message);                        // false: the other end is gone
  std::optional<Message> receive();                  // nothing: the other end is gone

 private:
  int socket_;
};

}  // namespace trace
