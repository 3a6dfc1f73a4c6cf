// What is told of a job whose worker did not answer, and the limits under which workers do jobs.
#pragma once

#include "batch/job.hpp"
#include "process/finished_job.hpp"

namespace trace {

// Of the worker that does this job. Where it runs another program that one has the job's own limits, and the
// worker gets more: to tell of it, and to look at its picture.
Limits worker_limits(const Job& job);

// "scene.ray: error: not done after 1 s, the limit of time for one scene (--timeout)", and so on; also used
// for other programs.
std::string failure_message(const Job& job, const Outcome& outcome);

// The word for a record's "outcome".
const char* outcome_word(const Outcome& outcome);

// The job's record; its old picture is removed.
Record failure_record(const Job& job, const FinishedJob& finished);

}  // namespace trace
