// A job done: the picture drawn and compared.
#pragma once

#include "batch/job.hpp"
#include "batch/record.hpp"
#include "process/blob_exchange.hpp"

namespace trace {

// The words of a record's "outcome".
namespace outcome {
inline constexpr const char
    *rendered = "rendered",
    *failed = "failed",                                    // the program says so; the message tells why
        *crashed = "crashed",                              // a signal ended it
            *timeout = "timeout",                          // it was stopped at its limit of time
                *memory = "memory",                        // or of memory
                    *no_picture = "no-picture",            // it ended well and left none
                        *stale_picture = "stale-picture",  // it left one that is older than its run
                            *bad_picture = "bad-picture";  // it left one that cannot be read
}

// The record of a job before it is done: what does not depend on how it ends.
Record new_record(const Job& job);

// Sets the names of the record's pictures as this run sees them.
void place(const Job& job, Record& record);

// Draws the picture and tells all but the comparison. A picture that an earlier run left goes away where
// there is no new one. `program` is own_program_hash(). Throws std::bad_alloc.
Record draw_job(const Job& job, const std::string& program, BlobExchange& exchange);

// Compares the picture that a record tells of with the job's solution, if there is one, and sets the record's
// comparison. Throws std::bad_alloc.
void compare_job(const Job& job, const std::string& program, Record& record);

}  // namespace trace
