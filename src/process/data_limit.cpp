#include "process/data_limit.hpp"

#include <algorithm>

#include "process/process_files.hpp"
#include "process/sanitizers.hpp"

namespace trace {

DataLimit::DataLimit(std::uint64_t bytes) {
  if (bytes == 0 || built_with_sanitizer || getrlimit(RLIMIT_DATA, &before_) != 0) return;
  rlimit lower = before_;
  lower.rlim_cur = std::min<rlim_t>(before_.rlim_cur, data_size() + bytes);
  set_ = setrlimit(RLIMIT_DATA, &lower) == 0;
}

DataLimit::~DataLimit() {
  if (set_) setrlimit(RLIMIT_DATA, &before_);
}

}  // namespace trace
