#include "process/blob.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace trace {
namespace {

bool write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(std::size_t(written));
  }
  return true;
}

}  // namespace

Blob make_blob(std::vector<std::uint8_t> bytes) {
  auto owner = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
  return {*owner, owner};
}

Descriptor share_bytes(std::span<const std::uint8_t> bytes) {
  Descriptor shared(memfd_create("blob", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  constexpr int for_ever = F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
  if (!shared || !write_all(shared.get(), bytes) || fcntl(shared.get(), F_ADD_SEALS, for_ever) != 0)
    return {};
  return shared;
}

std::optional<Blob> map_blob(const Descriptor& shared) {
  if (!shared) return std::nullopt;
  const auto size = std::size_t(shared_size(shared));
  if (size == 0) return Blob{};
  // MAP_PRIVATE: kernels before 6.7 refuse MAP_SHARED of a file sealed against writing even for reading. The
  // pages are the same ones in every process all the same.
  void* start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, shared.get(), 0);
  if (start == MAP_FAILED) return std::nullopt;
  const std::shared_ptr<const void> owner(start, [size](void* mapped) { munmap(mapped, size); });
  return Blob{{static_cast<const std::uint8_t*>(start), size}, owner};
}

std::uint64_t shared_size(const Descriptor& shared) {
  struct stat status {};
  return fstat(shared.get(), &status) == 0 ? std::uint64_t(status.st_size) : 0;
}

}  // namespace trace
