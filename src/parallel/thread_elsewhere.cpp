#include "parallel/thread_elsewhere.hpp"

#include <system_error>

namespace trace {
namespace {

// One of `allowed` that is not the caller's own; all of them if there is no other.
cpu_set_t another(const cpu_set_t& allowed, int turn) {
  const int others = CPU_COUNT(&allowed) - 1, own = sched_getcpu();
  if (others < 1 || own < 0 || own >= CPU_SETSIZE || !CPU_ISSET(own, &allowed)) return allowed;
  int left = turn % others;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (cpu == own || !CPU_ISSET(cpu, &allowed) || left-- > 0) continue;
    cpu_set_t result;
    CPU_ZERO(&result);
    CPU_SET(cpu, &result);
    return result;
  }
  return allowed;
}

}  // namespace

ThreadElsewhere::ThreadElsewhere(std::function<void()> work, int turn) : work_(std::move(work)) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  CPU_ZERO(&allowed_);
  // Where the system does not tell (more processors than a set holds), the thread starts wherever.
  if (sched_getaffinity(0, sizeof allowed_, &allowed_) == 0) {
    const cpu_set_t first = another(allowed_, turn);
    pthread_attr_setaffinity_np(&attributes, sizeof first, &first);
  }
  int error = pthread_create(&thread_, &attributes, &run, this);
  pthread_attr_destroy(&attributes);
  if (error == EINVAL)
    error = pthread_create(&thread_, nullptr, &run, this);  // that processor was taken away
  if (error != 0) throw std::system_error(error, std::system_category(), "no further thread");
}

ThreadElsewhere::~ThreadElsewhere() {
  pthread_join(thread_, nullptr);
}

void* ThreadElsewhere::run(void* self) {
  auto& thread = *static_cast<ThreadElsewhere*>(self);
  if (CPU_COUNT(&thread.allowed_) > 0) {
    pthread_setaffinity_np(pthread_self(), sizeof thread.allowed_, &thread.allowed_);
  }
  thread.work_();
  return nullptr;
}

}  // namespace trace
