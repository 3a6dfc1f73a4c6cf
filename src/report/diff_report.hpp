// What `trace diff` found: the pairs of pictures with their judgements. Plain data; diff_json.hpp,
// diff_csv.hpp and diff_junit.hpp write it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/judge.hpp"

namespace trace {

struct ComparedPair {
  std::string name;                            // "simple/box"
  std::optional<std::string> reference, test;  // paths; empty where there is no such file
  Judgement judgement;
};

struct DiffReport {
  std::string reference, test;  // the two pictures or folders, as the user wrote them
  std::vector<ComparedPair> pairs;
  bool incomplete = false;  // a folder could not be read, or a heat map not written

  int status() const;  // the largest exit_status of the pairs, 0 without pairs; 3 where it is incomplete
  std::size_t count(Verdict verdict) const;
};

// Every verdict, in the order in which they are counted and listed.
inline constexpr Verdict all_verdicts[] = {
    Verdict::identical,  Verdict::within,       Verdict::beyond,
    Verdict::not_finite, Verdict::size_differs, Verdict::channels_differ,
    Verdict::unreadable, Verdict::missing,      Verdict::extra};

}  // namespace trace
