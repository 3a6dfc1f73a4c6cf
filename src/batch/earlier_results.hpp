// What an earlier run of a batch left in its journal, as far as it still holds.
#pragma once

#include <map>
#include <string>

#include "batch/fingerprint.hpp"
#include "batch/job.hpp"

namespace trace {

class EarlierResults {
 public:
  // `records` must outlive this. What is not a record of this version of the program is passed over; of
  // several for one job the last counts.
  EarlierResults(const std::vector<Record>& records, const std::string& program);

  enum class Left { everything, comparison, nothing };

  // What is left to be done of a job, and the record of what is done already.
  Left left_of(const Job& job, Record& record);

  // Whether the file in the picture's place is one that an earlier run drew.
  bool drew_picture_of(const Job& job) const;

  // How long its drawing took then, in seconds; negative where it is not known.
  double seconds_of(const Job& job) const;

 private:
  const Record* find(const Job& job) const;

  std::map<std::pair<std::string, std::string>, const Record*> latest_;  // by scene and renderer
  std::string program_;
  FileHashes files_;
};

}  // namespace trace
