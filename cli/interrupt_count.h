// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a wish to come to an end, for commands that finish what they are in the middle of.
#pragma once

namespace tactics {

/// From now on SIGINT, SIGTERM and SIGHUP, those that the caller of the program does not ignore, end nothing but are counted.
void count_interrupts();
/// How many there were.
int interrupts() noexcept;

}  // namespace tactics
