// SPDX-License-Identifier: Apache-2.0
// A process shuts itself in before it touches what a stranger wrote. From then on it can compute, read what it needs and write to
// what it has open, and nothing else, whatever the stranger's bytes make of it.
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

/// Ends this process when its parent ends, also if that has ended already: `parent` is its id. Or when a limit is passed. It
/// opens no file but the one behind `readable`, and that only for reading (Landlock, Linux 5.13); no socket, no other program, no
/// other process, no file written, removed or renamed (seccomp). Where the kernel has one of the two only, that one holds; the
/// limits hold everywhere. Threads may still be started. There is no way back. Called while there is one thread. Never fails
/// loudly: what the kernel refuses is left out.
void shut_in(int readable, pid_t parent, const CageLimits& limits = {});

/// The same for another program that takes this process over next (exec) and reads its standard input, which it may open again as
/// /dev/fd/0. It opens files in or at `readable` paths for reading, as programs need libraries and data; paths that are not there
/// are passed over. What it may ask of the kernel differs from version to version, so here calls are refused by name: sockets,
/// processes, signals to others, changes of any file, leaving its group or its limits.
void shut_in_program(std::span<const std::string> readable, pid_t parent, const CageLimits& limits);

}  // namespace tactics
