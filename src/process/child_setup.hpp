// What a process does first after fork(). Nothing here allocates or takes a lock, so that it may also be done
// in the child of a process that has several threads.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace trace {

// `signal` is sent to this process when the thread that forked it ends. Ends this process at once if `parent`
// is gone already.
void die_with(pid_t parent, int signal);

// Every signal has its default action and none is blocked. With `keep_crashes` the handlers of the signals by
// which a program crashes stay.
void default_signals(bool keep_crashes = false);

// No core file.
void no_core_file();

// `descriptor` becomes number `number`, and stays open over exec.
void place_descriptor(int descriptor, int number);

// Standard input reads nothing.
void no_standard_input();

}  // namespace trace
