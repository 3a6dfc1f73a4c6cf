// One line of the table of hard cases: how one form of the arithmetic did on one workload.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/hard/digest.hpp"

namespace trace::hard {

// The form that keeps the promise; all others are there to be compared with.
inline constexpr std::string_view ours = "trace";

struct Row {
  std::string form;      // `ours`, "textbook", "Embree 3 robust", ...
  std::string workload;  // "closed sphere", "moved by 1e9 sizes", ...; may be empty
  std::uint64_t rays = 0;
  std::uint64_t misses = 0;     // hits that were lost, contact shadows among them
  std::uint64_t self_hits = 0;  // hits of the surface that the ray leaves
  std::uint64_t parity = 0;     // crossings told twice or not at all, seen from inside a closed surface
  std::uint64_t wrong = 0;      // any other answer that is not the true one
  double largest_error = 0;     // of t, relative; 0 where it is not measured
  // Of what was answered; 0 where it is not told. Digests of parts are added, so that their order does not
  // matter.
  std::uint64_t digest = 0;

  explicit Row(std::string_view of_form, std::string_view on_workload = {})
      : form(of_form), workload(on_workload) {}

  std::uint64_t failures() const { return misses + self_hits + parity + wrong; }

  void note_error(double relative) { largest_error = std::max(largest_error, relative); }

  void add(const Row& part) {
    rays += part.rays;
    misses += part.misses;
    self_hits += part.self_hits;
    parity += part.parity;
    wrong += part.wrong;
    largest_error = std::max(largest_error, part.largest_error);
    digest += part.digest;
  }
};

// All failures of one form.
inline std::uint64_t failures_of(const std::vector<Row>& rows, std::string_view form) {
  std::uint64_t sum = 0;
  for (const Row& row : rows) sum += row.form == form ? row.failures() : 0;
  return sum;
}

}  // namespace trace::hard
