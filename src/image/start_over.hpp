// The program in two forms. `trace` is linked wholly statically where the system has what that needs: it
// starts in two thirds of the time, but can load no shared object. `trace_dynamic` beside it is the same
// program with the dynamic linker, and can. Where the first comes upon what only the second can do, it
// becomes the second, which starts over with the same arguments. That is right as long as nothing was shown
// or written, and nothing read that can be read only once.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace trace {

inline constexpr const char* dynamic_program_name = "trace_dynamic";

// Becomes trace_dynamic, from the directory of the running program or ../lib/trace from there. Returns only
// if there is no such program to be run.
void start_over_dynamically();

// Whether reading all of these again gives the same: each is a regular file, or is not there at all. Not so
// standard input ("-") and pipes. Empty names stand for no file.
bool can_be_read_again(std::initializer_list<std::string_view> files);

}  // namespace trace
