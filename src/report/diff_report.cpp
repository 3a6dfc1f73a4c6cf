#include "report/diff_report.hpp"

#include <algorithm>

namespace trace {

int DiffReport::status() const {
  int worst = incomplete ? exit_status(Verdict::unreadable) : 0;
  for (const ComparedPair& pair : pairs) worst = std::max(worst, exit_status(pair.judgement.verdict));
  return worst;
}

std::size_t DiffReport::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      pairs, [&](const ComparedPair& pair) { return pair.judgement.verdict == verdict; }));
}

}  // namespace trace
