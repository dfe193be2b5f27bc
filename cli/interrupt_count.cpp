// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt_count.h"

#include <signal.h>

#include <initializer_list>

namespace tactics {

namespace {

volatile sig_atomic_t counted = 0;

}  // namespace

void count_interrupts() {
    struct sigaction action {};
    action.sa_handler = [](int) { counted = counted + 1; };
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        if (sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);
    }
}

int interrupts() noexcept { return counted; }

}  // namespace tactics
