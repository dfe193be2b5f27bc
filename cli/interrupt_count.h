// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a request to end, for commands that first finish their current step.
#pragma once

namespace tactics {

/// From now on, SIGINT, SIGTERM and SIGHUP (except those that the program's caller ignores) are only counted.
void count_interrupts();
/// The number of signals.
int interrupts() noexcept;

}  // namespace tactics
