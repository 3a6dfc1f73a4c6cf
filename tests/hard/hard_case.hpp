// A hard case: a promise about arithmetic at its limits, the rays that try it, and what came of them.
#pragma once

#include "tests/hard/row.hpp"

namespace trace::hard {

// `run` shoots about `rays` rays in all and tells how each form did, `ours` first. It draws the same rays on
// every machine and for every number of threads. Truth comes from exact or wider arithmetic, or from
// reasoning about the case, never from `ours`.
struct HardCase {
  int row;           // of the table of methods: 1 watertight triangles ... 14 attenuation; 15 whole pictures
  std::string name;  // the promise, in the words of its test
  std::string says;  // two sentences for the table: what makes it hard, what keeps the promise
  std::uint64_t quick, full;  // rays within the tests, and for the table
  std::vector<Row> (*run)(std::uint64_t rays);
};

// All, in the order of their rows.
std::vector<HardCase> hard_cases();

// The case of this name, which must exist.
HardCase hard_case(std::string_view name);

// The lists that make up hard_cases(), one a file.
void add_triangle_cases(std::vector<HardCase>& cases);   // rows 1 and 2
void add_traversal_cases(std::vector<HardCase>& cases);  // rows 3, 4 and 11
void add_leaving_cases(std::vector<HardCase>& cases);    // row 5
void add_curved_cases(std::vector<HardCase>& cases);     // rows 6 and 7
void add_space_cases(std::vector<HardCase>& cases);      // rows 8 and 9
void add_picture_cases(std::vector<HardCase>& cases);    // row 10, and scenes told in other words
void add_light_cases(std::vector<HardCase>& cases);      // rows 12, 13 and 14

}  // namespace trace::hard
