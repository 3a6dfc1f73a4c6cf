// A job's picture drawn by this program.
#pragma once

#include "batch/job.hpp"
#include "batch/record.hpp"
#include "process/blob_exchange.hpp"

namespace trace {

// Fills in the record's outcome, message, times, rays and inputs; the picture is written whole or not at all.
void draw(const Job& job, BlobExchange& exchange, Record& record);

}  // namespace trace
