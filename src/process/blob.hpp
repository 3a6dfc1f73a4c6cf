// Bytes that never change, wherever they lie: in this process, or in memory that several processes share.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "process/descriptor.hpp"

namespace trace {

struct Blob {
  std::span<const std::uint8_t> bytes;
  std::shared_ptr<const void> owner;  // the bytes stay as long as any copy of this does
};

// Bytes of this process alone.
Blob make_blob(std::vector<std::uint8_t> bytes);

// A file without a name in memory that holds the bytes and can never be changed again, by anyone. None where
// the system refuses.
Descriptor share_bytes(std::span<const std::uint8_t> bytes);

// The bytes of such a file, mapped to be read. Nothing where the system refuses.
std::optional<Blob> map_blob(const Descriptor& shared);

// Its size in bytes.
std::uint64_t shared_size(const Descriptor& shared);

}  // namespace trace
