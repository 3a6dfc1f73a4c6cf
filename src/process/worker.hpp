// The worker's side of a WorkerPool: takes a job, does it, sends the answer, until the supervisor is gone.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "process/blob_exchange.hpp"

namespace trace {

// Runs in a worker. What it throws ends the worker and is reported with the job.
using Work = std::function<std::string(std::string_view job, BlobExchange& blobs)>;

// What a job took, as its worker saw it.
struct JobFigures {
  double seconds = 0;
  double cpu_seconds_so_far = 0;  // of the worker since it started, with the programs it waited for
  std::uint64_t peak_memory_bytes = 0;
};

// Never returns: the worker ends with _exit, so that nothing of what it inherited is destroyed, flushed or
// run twice, not even if the work calls std::exit.
[[noreturn]] void run_worker(int socket, const Work& work);

}  // namespace trace
