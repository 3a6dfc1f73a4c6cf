#include "process/message.hpp"

#include <sys/socket.h>
#include <sys/uio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace trace {
namespace {

constexpr std::uint64_t largest_body = std::uint64_t{4} << 30;
constexpr std::size_t chunk = std::size_t{256} << 10;

// Room for one descriptor in the control part of a message.
struct Control {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> bytes{};
};

void attach(msghdr& parts, Control& control, int descriptor) {
  parts.msg_control = control.bytes.data();
  parts.msg_controllen = control.bytes.size();
  cmsghdr* header = CMSG_FIRSTHDR(&parts);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(header), &descriptor, sizeof(int));
}

Descriptor attached(msghdr& parts) {
  const cmsghdr* header = CMSG_FIRSTHDR(&parts);
  if (header == nullptr || header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS ||
      header->cmsg_len != CMSG_LEN(sizeof(int)))
    return {};
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(header), sizeof(int));
  return Descriptor(descriptor);
}

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK;
}

}  // namespace

bool MessageReader::read_header(int socket) {
  while (header_done_ < sizeof header_) {
    iovec part{reinterpret_cast<char*>(&header_) + header_done_, sizeof header_ - header_done_};
    Control control;
    msghdr parts{};
    parts.msg_iov = &part;
    parts.msg_iovlen = 1;
    parts.msg_control = control.bytes.data();
    parts.msg_controllen = control.bytes.size();
    const ssize_t count = recvmsg(socket, &parts, MSG_CMSG_CLOEXEC);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      closed_ = count == 0 || !would_block();
      return false;
    }
    if (Descriptor descriptor = attached(parts)) message_.descriptor = std::move(descriptor);
    header_done_ += std::size_t(count);
    if (header_done_ == sizeof header_ &&
        (header_.kind > MessageKind::blob_not_made || header_.size > largest_body)) {
      closed_ = true;
      return false;
    }
  }
  return true;
}

bool MessageReader::read_body(int socket) {
  const auto size = std::size_t(header_.size);
  std::string& body = message_.body;
  body.reserve(size);
  while (body.size() < size) {
    const std::size_t before = body.size();
    body.resize(before + std::min(size - before, chunk));
    const ssize_t count = recv(socket, body.data() + before, body.size() - before, 0);
    body.resize(before + std::size_t(std::max<ssize_t>(count, 0)));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      closed_ = count == 0 || !would_block();
      return false;
    }
  }
  return true;
}

std::optional<Message> MessageReader::read(int socket) {
  if (closed_ || !read_header(socket) || !read_body(socket)) return std::nullopt;
  message_.kind = header_.kind;
  message_.number = header_.number;
  header_done_ = 0;
  return std::exchange(message_, Message());
}

bool MessageWriter::flush(int socket) {
  while (!pending_.empty()) {
    Message& message = pending_.front();
    MessageHeader header{message.kind, 0, message.number, message.body.size()};
    std::array<iovec, 2> part{};
    std::size_t parts_used = 0;
    if (done_ < sizeof header)
      part[parts_used++] = {reinterpret_cast<char*>(&header) + done_, sizeof header - done_};
    const std::size_t body_done = done_ - std::min(done_, sizeof header);
    if (body_done < message.body.size())
      part[parts_used++] = {message.body.data() + body_done, message.body.size() - body_done};

    msghdr parts{};
    parts.msg_iov = part.data();
    parts.msg_iovlen = parts_used;
    Control control;
    if (done_ == 0 && message.descriptor) attach(parts, control, message.descriptor.get());
    const ssize_t count = sendmsg(socket, &parts, MSG_NOSIGNAL);
    if (count < 0) {
      if (errno == EINTR) continue;
      return would_block();
    }
    done_ += std::size_t(count);
    if (done_ == sizeof header + message.body.size()) {
      pending_.pop_front();
      done_ = 0;
    }
  }
  return true;
}

bool Channel::send(Message message) {
  MessageWriter writer;
  writer.put(std::move(message));
  return writer.flush(socket_);
}

std::optional<Message> Channel::receive() {
  return MessageReader().read(socket_);
}

}  // namespace trace
