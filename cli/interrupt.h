// SPDX-License-Identifier: Apache-2.0
// Ctrl-C: the program ends at once, but never in the middle of a file.
#pragma once

#include <array>
#include <csignal>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

namespace tactics {

/// While it lives, a thread waits for SIGINT, SIGTERM and SIGHUP (those that the caller of the program does not ignore),
/// calls `before_end`, removes the files that are still unfinished, ends the programs that run for this one, and then lets the
/// signal end the program as usual, so that shells and make see it. The signals may reach any thread, those of libraries, too,
/// which are not ours to mask. One at a time. Throws std::system_error if the process has no descriptor left.
class Interrupt {
public:
    explicit Interrupt(std::function<void()> before_end);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

private:
    void wait();

    std::function<void()> before_end_;
    std::array<int, 2> pipe_{-1, -1};  // from the handler to the thread: a signal's number a byte, 0 when the work is over
    std::vector<std::pair<int, struct sigaction>> before_;
    std::thread thread_;
};

}  // namespace tactics
