// Large read-only data (decoded textures) that is made once for all workers of a pool.
//
// The first worker that asks for a key makes the bytes; they are put into sealed shared memory, whose
// descriptor goes through the supervisor to every other worker that asks. One that asks meanwhile waits (its
// time limit does too); where the making failed or its worker died, the next one makes the bytes itself. What
// a worker has had it keeps mapped, so that asking again costs no message. Where shared memory cannot be had
// the bytes are made in each worker.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/blob.hpp"
#include "process/lru_cache.hpp"
#include "process/message.hpp"

namespace trace {

// Of what supervisor and workers keep in case it is asked for again. Mapped pages of one blob are the same
// ones in all of them.
inline constexpr std::size_t kept_blob_bytes = std::size_t{1} << 30;
inline constexpr std::size_t kept_blobs = 256;

class BlobExchange {
 public:
  using Make = std::function<std::vector<std::uint8_t>()>;

  BlobExchange() = default;  // outside a worker: get() just makes
  explicit BlobExchange(Channel supervisor) : supervisor_(supervisor) {}

  // The bytes of `key`, which tells everything they depend on. Whatever `make` throws leaves; the next one
  // who asks tries again. To be called by the thread that does the job; `make` may call it for other keys.
  Blob get(const std::string& key, const Make& make);

 private:
  Blob make_and_share(const std::string& key, const Make& make);

  std::optional<Channel> supervisor_;
  LruCache<Blob> kept_{kept_blob_bytes, kept_blobs};
};

}  // namespace trace
