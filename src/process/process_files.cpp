#include "process/process_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string>
#include <string_view>

#include "process/descriptor.hpp"

namespace trace {
namespace {

// The files read here are made by the kernel on reading and are short. Empty where there is none.
std::string contents(const std::string& file) {
  const Descriptor descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  std::string all;
  char part[4096];
  for (ssize_t count; descriptor && (count = read(descriptor.get(), part, sizeof part)) > 0;)
    all.append(part, std::size_t(count));
  return all;
}

// The next number in `text`, which is moved behind it. 0 where there is none.
std::uint64_t take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_of("0123456789"), text.size()));
  std::uint64_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(std::size_t(result.ptr - text.data()));
  return number;
}

std::string folder_of(pid_t process) {
  return fmt::format("/proc/{}", process);
}

// A line of such a file that is given in kB.
std::uint64_t field_bytes(const std::string& file, std::string_view field) {
  const std::string all = contents(file);
  const std::size_t at = all.find(field);
  if (at == std::string::npos) return 0;
  std::string_view rest = std::string_view(all).substr(at);
  return take_number(rest) * 1024;
}

void add_children(pid_t process, std::vector<pid_t>& all) {
  std::error_code gone;
  for (std::filesystem::directory_iterator task(folder_of(process) + "/task", gone), end;
       !gone && task != end; task.increment(gone)) {
    const std::string text = contents(task->path() / "children");
    std::string_view rest = text;
    while (const std::uint64_t child = take_number(rest)) all.push_back(pid_t(child));
  }
}

}  // namespace

ResidentMemory resident_memory(pid_t process) {
  const std::string text = contents(folder_of(process) + "/statm");
  std::string_view rest = text;
  take_number(rest);  // address space
  const auto page = std::uint64_t(sysconf(_SC_PAGESIZE));
  const std::uint64_t all = take_number(rest) * page;
  const std::uint64_t shared = take_number(rest) * page;
  return {all, all - std::min(all, shared)};
}

std::uint64_t proportional_memory(pid_t process) {
  const std::uint64_t bytes = field_bytes(folder_of(process) + "/smaps_rollup", "\nPss:");
  return bytes > 0 ? bytes : resident_memory(process).all;
}

std::uint64_t peak_resident(pid_t process) {
  return field_bytes(folder_of(process) + "/status", "\nVmHWM:");
}

bool reset_peak_resident() {
  const Descriptor descriptor(open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC));
  return descriptor && write(descriptor.get(), "5", 1) == 1;
}

std::uint64_t data_size() {
  return field_bytes("/proc/self/status", "\nVmData:");
}

std::vector<pid_t> descendants(pid_t process) {
  std::vector<pid_t> all;
  add_children(process, all);
  for (std::size_t i = 0; i < all.size(); ++i) add_children(all[i], all);
  return all;
}

}  // namespace trace
