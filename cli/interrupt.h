// Ctrl-C: the program ends at once, but never in the middle of a file.
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace tactics {

/// While it lives, a thread waits for SIGINT, SIGTERM and SIGHUP (those that the caller of the program does not ignore),
/// calls `before_end`, removes the files that are still unfinished, and then lets the signal end the program as usual, so that shells and make see it. Create it before
/// the threads that work: they inherit the mask that keeps these signals from them.
class Interrupt {
public:
    explicit Interrupt(std::function<void()> before_end);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

private:
    void wait();

    std::function<void()> before_end_;
    sigset_t waited_{};
    sigset_t before_{};
    std::atomic<bool> over_ = false;
    std::thread thread_;
};

}  // namespace tactics
