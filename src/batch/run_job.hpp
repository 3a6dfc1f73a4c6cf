// A job done: the picture drawn and compared.
#pragma once

#include "batch/job.hpp"
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

// Draws the picture, unless job.finished tells that it is there, compares it, and tells all in a record. A
// picture that an earlier run left goes away where there is no new one. `program` is own_program_hash().
// Throws std::bad_alloc.
Record run_job(const Job& job, const std::string& program, BlobExchange& exchange);

}  // namespace trace
