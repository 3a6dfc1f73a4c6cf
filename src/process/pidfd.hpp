// Descriptors of processes: pidfd_open(), pidfd_send_signal(). They are not confused by a reused process
// number, and poll() tells when the process has ended.
//
// The header of glibc 2.36 forgets to give its functions C linkage.
#pragma once

#include <fcntl.h>
#include <signal.h>

extern "C" {
#include <sys/pidfd.h>
}
