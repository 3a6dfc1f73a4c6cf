#include "tests/process/pool_jobs.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <thread>

namespace trace::test {

std::size_t open_files() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return std::size_t(std::distance(begin(all), end(all)));
}

bool alive(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  if (!std::getline(file, text)) return false;
  const char state = text.at(text.rfind(')') + 2);
  return state != 'Z' && state != 'X';
}

bool soon_gone(pid_t process) {
  const auto end = Clock::now() + long_enough;
  while (alive(process) && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return !alive(process);
}

void crash(int signal) {
  std::signal(signal, SIG_DFL);
  kill(getpid(), signal);
  for (;;) pause();
}

SharedNumber::SharedNumber() {
  void* page = mmap(nullptr, sizeof *number_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  REQUIRE(page != MAP_FAILED);
  number_ = ::new (page) std::atomic<int>(0);
}

SharedNumber::~SharedNumber() {
  munmap(number_, sizeof *number_);
}

void SharedNumber::wait_for_change() const {
  const auto end = Clock::now() + long_enough;
  while (*number_ == 0 && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void exhaust_memory() {
  constexpr std::size_t part = 4 << 20;
  std::vector<std::unique_ptr<char[]>> all;
  for (int i = 0; i < 1024; ++i) {
    all.push_back(std::make_unique<char[]>(part));
    std::memset(all.back().get(), i | 1, part);
  }
}

}  // namespace trace::test
