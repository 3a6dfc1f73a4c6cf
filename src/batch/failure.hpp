// What is told of a job whose worker did not answer, and the limits under which workers do jobs.
#pragma once

#include "batch/job.hpp"
#include "batch/record.hpp"
#include "process/finished_job.hpp"

namespace trace {

// Of the worker that draws. Where it runs another program, that one has the job's own limits and the worker
// more.
Limits drawing_limits(const Job& job);

// Of the worker that compares: enough for the largest pictures there are.
Limits comparing_limits();

// "scene.ray: error: not done after 1 s, the limit of time for one scene (--timeout)", and so on; also used
// for other programs.
std::string failure_message(const Job& job, const std::string& who, const Outcome& outcome);

// The word for a record's "outcome".
const char* outcome_word(const Outcome& outcome);

// Of a job that was not drawn; its old picture is removed.
Record failure_record(const Job& job, const FinishedJob& finished);

// Sets the comparison of one that was drawn, but whose comparison ended badly.
void set_comparison_failure(const Job& job, const FinishedJob& finished, Record& record);

}  // namespace trace
