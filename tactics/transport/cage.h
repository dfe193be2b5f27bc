// SPDX-License-Identifier: Apache-2.0
// A process isolates itself before it reads untrusted input. From then on it can only compute, read what it needs and write to
// open descriptors, even if the input takes control of it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <span>
#include <string>

namespace tactics {

struct CageLimits {
    std::size_t memory = std::size_t{4} << 30;  ///< bytes that it may ask for (RLIMIT_DATA)
    unsigned processor_seconds = 120;           ///< of all its threads together
    unsigned seconds = 600;                     ///< by the clock
};

/// Makes this process end when its parent (with id `parent`) ends, even if that has ended already, or when a limit is passed. It
/// can open no file except the one behind `readable`, and that only for reading (Landlock, Linux 5.13); no socket, no other
/// program, no other process, no file written, removed or renamed (seccomp). If the kernel has only one of the two, that one
/// applies; the limits always apply. Threads may still be started. It cannot be undone. Call it while there is one thread. It
/// never reports failure: protections that the kernel refuses are left out.
void shut_in(int readable, pid_t parent, const CageLimits& limits = {});

/// The same for another program that replaces this process (exec) and reads its standard input, which it may reopen as /dev/fd/0.
/// It may open files in or at `readable` paths for reading, because programs need libraries and data; missing paths are ignored.
/// The system calls that it needs differ between versions, so calls are refused by name: sockets, processes, signals to others,
/// changes of any file, leaving its group or its limits.
void shut_in_program(std::span<const std::string> readable, pid_t parent, const CageLimits& limits);

}  // namespace tactics
