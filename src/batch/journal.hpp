// The results of a batch as they come: a file of one JSON object a line.
//
// A line is with the system as soon as it is appended, so that no end of this process loses it, and on the
// disk half a second later at most. What a power cut leaves at the end of the file, half a line, is dropped
// when the file is opened again.
#pragma once

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "batch/record.hpp"

namespace trace {

struct JournalError : std::runtime_error {
  using runtime_error::runtime_error;
};

class Journal {
 public:
  // Opens the file or makes it, and locks it: two batches must not write to one folder. Throws JournalError,
  // whose text names the file.
  // `fresh`: what is in it is dropped.
  explicit Journal(const std::filesystem::path& file, bool fresh = false);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  // What was there when it was opened, oldest first; lines that are no JSON objects are left out.
  const std::vector<Record>& earlier() const { return earlier_; }

  void append(const Record& record);  // throws JournalError
  void flush();                       // to the disk; throws JournalError

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::chrono::steady_clock::time_point flushed_{};
  std::vector<Record> earlier_;
};

}  // namespace trace
