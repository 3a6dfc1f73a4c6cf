#include "image/memory_file.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "image/image.hpp"
#include "image/system_error.hpp"

namespace trace {

MemoryFile::MemoryFile() : descriptor_(memfd_create("picture", MFD_CLOEXEC)) {
  if (descriptor_ < 0) throw ImageError(system_reason(errno));
}

MemoryFile::~MemoryFile() {
  close(descriptor_);
}

std::string MemoryFile::path() const {
  return fmt::format("/proc/self/fd/{}", descriptor_);
}

std::vector<std::uint8_t> MemoryFile::bytes() const {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) throw ImageError(system_reason(errno));
  std::vector<std::uint8_t> all(std::size_t(status.st_size));
  std::size_t done = 0;
  while (done < all.size()) {
    const ssize_t count = pread(descriptor_, all.data() + done, all.size() - done, off_t(done));
    if (count <= 0) throw ImageError(system_reason(count < 0 ? errno : EIO));
    done += std::size_t(count);
  }
  return all;
}

}  // namespace trace
