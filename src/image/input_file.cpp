#include "image/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "image/image.hpp"
#include "image/system_error.hpp"

namespace trace {

InputFile::InputFile(const std::filesystem::path& path) {
  // O_NONBLOCK: opening a pipe must not wait for its writer. It means nothing for regular files.
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    if (errno == ENOENT || errno == ENOTDIR) throw ImageError("no such file");
    throw ImageError(system_reason(errno));
  }
  stream_.reset(fdopen(descriptor, "rb"));
  if (!stream_) {
    const int error = errno;
    close(descriptor);
    throw ImageError(system_reason(error));
  }
  struct stat status {};
  if (fstat(descriptor, &status) != 0) throw ImageError(system_reason(errno));
  if (S_ISDIR(status.st_mode)) throw ImageError("is a directory");
  if (!S_ISREG(status.st_mode)) throw ImageError("not a regular file");
  size_ = std::uint64_t(status.st_size);
}

std::vector<std::uint8_t> InputFile::first(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  bytes.resize(std::fread(bytes.data(), 1, count, stream()));
  if (std::ferror(stream())) throw ImageError(system_reason(errno));
  std::rewind(stream());
  return bytes;
}

}  // namespace trace
