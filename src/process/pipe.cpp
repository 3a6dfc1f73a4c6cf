#include "process/pipe.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace trace {

Pipe::Pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  read = above_standard(Descriptor(ends[0]));
  write = above_standard(Descriptor(ends[1]));
}

void must_not_block(const Descriptor& descriptor) {
  fcntl(descriptor.get(), F_SETFL, fcntl(descriptor.get(), F_GETFL) | O_NONBLOCK);
}

void read_some(Descriptor& from, BoundedText& to) {
  std::array<char, 16384> part;
  ssize_t count = -1;
  for (int parts = 0; from && parts < 16; ++parts) {
    count = ::read(from.get(), part.data(), part.size());
    if (count <= 0) break;
    to.append({part.data(), std::size_t(count)});
  }
  if (count == 0) from.reset();
}

}  // namespace trace
