// Forks a worker and connects it.
#pragma once

#include <sys/types.h>

#include <functional>

#include "process/descriptor.hpp"
#include "process/worker.hpp"

namespace trace {

struct ForkedWorker {
  pid_t pid = -1;
  Descriptor process;  // a pidfd
  Descriptor socket;   // for messages
  Descriptor errors;   // what it writes to standard output and error
};

// `in_child` runs first in the new process, to let go of what belongs to the supervisor. The descriptors here
// do not block. Throws std::system_error.
ForkedWorker fork_worker(const Work& work, const std::function<void()>& in_child);

}  // namespace trace
