#include "process/worker.hpp"

#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <utility>

#include "process/cpu_time.hpp"
#include "process/data_limit.hpp"
#include "process/message.hpp"
#include "process/process_files.hpp"

namespace trace {
namespace {

// Memory that a job freed but malloc kept would come on top of the next job's limit, so it is given back
// where it may be much.
constexpr std::uint64_t much_memory = std::uint64_t{16} << 20;

// The work's result or what it threw. The limit is lifted again when this returns.
Message do_job(const Message& job, const Work& work, BlobExchange& blobs) {
  Message result;
  try {
    const DataLimit limit(job.number);
    result.body = work(job.body, blobs);
    result.kind = MessageKind::answer;
  } catch (const std::bad_alloc&) {
    result.kind = MessageKind::out_of_memory;
  } catch (const std::exception& error) {
    result.kind = MessageKind::failed;
    result.body = error.what();
  } catch (...) {
    result.kind = MessageKind::failed;
    result.body = "exception of an unknown type";
  }
  return result;
}

Message figures_message(const JobFigures& figures) {
  Message message;
  message.kind = MessageKind::figures;
  message.body.assign(reinterpret_cast<const char*>(&figures), sizeof figures);
  return message;
}

void flush_output() {
  std::cout.flush();
  std::fflush(nullptr);
}

}  // namespace

void run_worker(int socket, const Work& work) {
  // The last one registered is called first, and ends the process before what the supervisor registered.
  on_exit(
      [](int status, void*) {
        flush_output();
        _exit(status);
      },
      nullptr);

  Channel supervisor(socket);
  BlobExchange blobs(supervisor);
  while (const std::optional<Message> job = supervisor.receive()) {
    const std::uint64_t before = resident_memory(getpid()).own;
    reset_peak_resident();
    const auto start = std::chrono::steady_clock::now();
    Message result = do_job(*job, work, blobs);
    flush_output();

    JobFigures figures;
    figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    figures.cpu_seconds_so_far = cpu_seconds_so_far();
    figures.peak_memory_bytes = peak_resident(getpid());
    const bool goes_on = result.kind == MessageKind::answer;
    supervisor.send(figures_message(figures));
    supervisor.send(std::move(result));
    if (!goes_on) _exit(1);
    if (resident_memory(getpid()).own > before + much_memory) malloc_trim(0);
  }
  _exit(0);
}

}  // namespace trace
