// SPDX-License-Identifier: Apache-2.0
#include <malloc.h>

#include "cli/command.h"

int main(int count, char** words) {
    // Planes of pixels come and go; kept, their memory is used again without the kernel clearing it anew: a quarter of the
    // page faults of a run. What a picture needs at most is bounded elsewhere (tactics/readers/read.h).
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    return tactics::run_program(count, words);
}
