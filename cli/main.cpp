// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <malloc.h>

#include <csignal>

#include "cli/command.h"

namespace {

// A standard stream that is closed leaves its number to the next file that is opened: then what is said of a job goes to the
// machine. Opened the wrong way round it stays as unusable as it was, and its number is taken.
void hold_standard_streams() {
    for (const int stream : {0, 1, 2})
        if (fcntl(stream, F_GETFD) < 0) static_cast<void>(!open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY));
}

}  // namespace

int main(int count, char** words) {
    // Planes of pixels come and go; kept, their memory is used again without the kernel clearing it anew: a quarter of the
    // page faults of a run. What a picture needs at most is bounded elsewhere (tactics/readers/read.h).
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    hold_standard_streams();
    // Exceeding ulimit -f gives an error message; the limit also applies to memory files for other programs.
    std::signal(SIGXFSZ, SIG_IGN);
    return tactics::run_program(count, words);
}
