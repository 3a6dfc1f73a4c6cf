#include "process/exec_strings.hpp"

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace trace {

ExecStrings::ExecStrings(std::vector<std::string> strings) : strings_(std::move(strings)) {
  for (std::string& one : strings_) pointers_.push_back(one.data());
  pointers_.push_back(nullptr);
}

std::vector<std::string> changed_environment(const std::vector<std::string>& changes) {
  std::vector<std::string> all = changes;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string own = *entry;
    const std::string name = own.substr(0, own.find('=') + 1);
    const bool changed = std::any_of(changes.begin(), changes.end(),
                                     [&](const std::string& change) { return change.starts_with(name); });
    if (!changed) all.push_back(own);
  }
  return all;
}

}  // namespace trace
