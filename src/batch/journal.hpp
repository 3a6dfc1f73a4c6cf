// The results of a batch as they come: a file of one JSON object a line.
//
// A line is on the disk before the next scene's is begun. What a power cut or a kill leaves at the end of the
// file, half a line, is dropped when the file is opened again.
#pragma once

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
  explicit Journal(const std::filesystem::path& file);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  // What was there when it was opened, oldest first; lines that are no JSON objects are left out.
  const std::vector<Record>& earlier() const { return earlier_; }

  void append(const Record& record);  // throws JournalError

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::vector<Record> earlier_;
};

}  // namespace trace
