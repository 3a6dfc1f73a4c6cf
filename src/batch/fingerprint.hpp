// What a picture and its comparison were made from, so that a later run makes only what is missing or
// changed.
#pragma once

#include <string>

#include "batch/content_hash.hpp"
#include "batch/job.hpp"
#include "batch/record.hpp"

namespace trace {

// An element of a record's "inputs": a file and the hash of its content, null where it could not be read.
// Names are made absolute, so that they mean the same from another working folder.
Record input(const std::filesystem::path& file, const std::optional<std::string>& hash);

// Everything but files that decides a job's picture: renderer, options, names. `program` is the hash of this
// program's own file: another build may draw another picture.
std::string picture_key(const Job& job, const std::string& program);

// Everything but the picture that decides its comparison: the solution's content, the tolerance.
std::string comparison_key(const Job& job, const std::string& program, FileHashes& files);

// The hash of the running program's file.
std::string own_program_hash();

// Where a shell would find this program; empty where it would not.
std::filesystem::path find_program(const std::string& name);

// Whether `record` is that of a picture made by this very job from files that are as they were, and the
// picture is as it was written.
bool picture_is_current(const Record& record, const Job& job, const std::string& program, FileHashes& files);

// Whether its comparison is too.
bool comparison_is_current(const Record& record, const Job& job, const std::string& program,
                           FileHashes& files);

}  // namespace trace
