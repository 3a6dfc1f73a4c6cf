// The supervisor's side of BlobExchange: who makes which blob, who waits for it, and the blobs themselves.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "process/blob_exchange.hpp"
#include "process/descriptor.hpp"
#include "process/lru_cache.hpp"

namespace trace {

class BlobBroker {
 public:
  using WorkerId = int;
  // What a worker is to be told: here it is, or, without a descriptor, make it yourself.
  struct Reply {
    WorkerId worker;
    Descriptor blob;
  };

  // `worker` asks. No reply: it has to wait. A worker that is making a blob never waits for another one, so
  // that no two can wait for each other.
  std::vector<Reply> wanted(WorkerId worker, const std::string& key);
  // `worker` made it; without a descriptor it could not, or could not share it.
  std::vector<Reply> made(WorkerId worker, const std::string& key, Descriptor blob);
  // `worker` has ended, whatever it was doing.
  std::vector<Reply> gone(WorkerId worker);

  // Makers and waiters are forgotten.
  void forget_workers() { making_.clear(); }
  // Closes everything: for a process that is not the supervisor.
  void clear();

 private:
  struct Making {
    WorkerId maker;
    std::deque<WorkerId> waiting;
  };
  bool is_making(WorkerId worker) const;

  std::map<std::string, Making> making_;
  LruCache<Descriptor> kept_{kept_blob_bytes, kept_blobs};
};

}  // namespace trace
