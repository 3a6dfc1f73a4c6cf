// A job's picture drawn by another program, which is taken at its result only.
//
// The program is given a name in a new folder to write to, so nothing that an earlier run left can pass for
// its picture. What it wrote is looked at and only then moved to where the picture belongs.
#pragma once

#include <string>
#include <vector>

#include "batch/job.hpp"
#include "batch/record.hpp"

namespace trace {

// The words of "./ray -r {depth} {scene} {out}", quotes as in a shell. {scene} and {out} must be there,
// {depth} and {width} may. Throws std::invalid_argument, whose text tells what is wrong.
std::vector<std::string> parse_renderer_command(const std::string& text);

// Fills in the record's outcome, message, times, memory and inputs.
void draw_with_program(const Job& job, Record& record);

// Removes the folders that programs wrote to when their batch was killed. Only for who holds the batch's
// journal.
void remove_leftovers(const std::vector<Job>& jobs);

}  // namespace trace
