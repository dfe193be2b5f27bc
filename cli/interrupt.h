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

/// While this object lives, a thread waits for SIGINT, SIGTERM and SIGHUP (except those that the program's caller ignores). It
/// then calls `before_end`, removes unfinished files, ends child programs, and lets the signal end the program as usual, so that
/// shells and make see it. The signals may reach any thread, including those of libraries, which we cannot mask. Only one object
/// at a time. Throws std::system_error if the process has no descriptor left.
class Interrupt {
public:
    explicit Interrupt(std::function<void()> before_end);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

private:
    void wait();

    std::function<void()> before_end_;
    std::array<int, 2> pipe_{-1, -1};  // from the handler to the thread: one byte per signal with its number, 0 when the work is
                                       // over
    std::vector<std::pair<int, struct sigaction>> before_;
    std::thread thread_;
};

}  // namespace tactics
