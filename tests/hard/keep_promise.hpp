// What the test of every hard case asks.
#pragma once

#include <catch2/catch.hpp>

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

// Runs the quick count of the hard case named as the test that calls this, and requires that `ours` keeps the
// promise. Returns the rows, so that the test can ask whether the case is hard: whether a textbook form fails
// it.
inline std::vector<Row> keep_promise() {
  const HardCase hard = hard_case(Catch::getResultCapture().getCurrentTestName());
  const std::vector<Row> rows = hard.run(hard.quick);
  std::uint64_t rays = 0;
  for (const Row& row : rows) {
    INFO(row.form << ", " << row.workload << ": " << row.rays << " rays, " << row.misses << " misses, "
                  << row.self_hits << " self-hits, " << row.parity << " parity, " << row.wrong << " wrong");
    if (row.form != ours) continue;
    rays += row.rays;
    CHECK(row.failures() == 0);
  }
  CHECK(rays > 0);
  return rows;
}

}  // namespace trace::hard
