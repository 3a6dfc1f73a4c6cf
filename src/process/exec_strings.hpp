// Arguments and environment in the form that exec takes.
#pragma once

#include <string>
#include <vector>

namespace trace {

class ExecStrings {
 public:
  explicit ExecStrings(std::vector<std::string> strings);
  ExecStrings(const ExecStrings&) = delete;
  ExecStrings& operator=(const ExecStrings&) = delete;

  // To each string in turn, then null; good as long as this.
  char* const* pointers() const { return pointers_.data(); }

 private:
  std::vector<std::string> strings_;
  std::vector<char*> pointers_;
};

// The environment of this process, with "NAME=value" entries added or put in the place of those of that name.
std::vector<std::string> changed_environment(const std::vector<std::string>& changes);

}  // namespace trace
