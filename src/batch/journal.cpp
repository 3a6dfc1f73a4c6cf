#include "batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "image/system_error.hpp"

namespace trace {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw JournalError(fmt::format("cannot write '{}': {}", file.string(), reason));
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  ssize_t count;
  while ((count = read(descriptor, buffer.data(), buffer.size())) > 0)
    text.append(buffer.data(), static_cast<std::size_t>(count));
  return text;
}

}  // namespace

Journal::Journal(const std::filesystem::path& file, bool fresh) : file_(file) {
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(file, system_reason(errno));
  // A lock of this process, not of the open file: workers forked later must not hold it on when this process
  // was killed and they are about to be.
  struct flock whole_file {};
  whole_file.l_type = F_WRLCK;
  if (fcntl(descriptor_, F_SETLK, &whole_file) != 0) {
    const int error = errno;
    close(descriptor_);
    fail(file, error == EACCES || error == EAGAIN ? "another batch is writing to it" : system_reason(error));
  }
  const std::string text = fresh ? "" : read_all(descriptor_);
  const std::size_t complete = text.rfind('\n') == text.npos ? 0 : text.rfind('\n') + 1;
  if ((fresh || complete != text.size()) && ftruncate(descriptor_, static_cast<off_t>(complete)) != 0) {
    const int error = errno;
    close(descriptor_);
    fail(file, system_reason(error));
  }
  for (std::size_t begin = 0; begin < complete;) {
    const std::size_t end = text.find('\n', begin);
    Record record = Record::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                  text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    if (record.is_object()) earlier_.push_back(std::move(record));
    begin = end + 1;
  }
}

Journal::~Journal() {
  close(descriptor_);
}

void Journal::append(const Record& record) {
  const std::string line = record.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t count = write(descriptor_, line.data() + done, line.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(file_, system_reason(errno));
    done += static_cast<std::size_t>(count);
  }
  using namespace std::chrono_literals;
  if (std::chrono::steady_clock::now() - flushed_ > 500ms) flush();
}

void Journal::flush() {
  if (fdatasync(descriptor_) != 0 && errno != EINVAL) fail(file_, system_reason(errno));
  flushed_ = std::chrono::steady_clock::now();
}

}  // namespace trace
