// SPDX-License-Identifier: Apache-2.0
// A loop with a steady rate by the monotonic clock, with statistics of its punctuality.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace tactics {

/// Time as a loop sees it; tests use a clock that they move by hand.
class Clock {
public:
    virtual ~Clock() = default;
    virtual double now() noexcept = 0;                  ///< s, monotonic
    virtual void wait_until(double time) noexcept = 0;  ///< s; returns at once if that is past
};

/// CLOCK_MONOTONIC and an absolute clock_nanosleep. While this object lives, its thread wakes without slack (PR_SET_TIMERSLACK 1,
/// with which half of the ticks come within 20 instead of 70 us), its memory is locked, and, if permitted, it runs ahead of all
/// other threads (SCHED_FIFO).
class MonotonicClock : public Clock {
public:
    explicit MonotonicClock(bool before_others);
    ~MonotonicClock() override;
    MonotonicClock(const MonotonicClock&) = delete;
    MonotonicClock& operator=(const MonotonicClock&) = delete;
    double now() noexcept override;
    void wait_until(double time) noexcept override;
    bool goes_before_others() const { return fifo_; }

private:
    bool fifo_ = false;
    int slack_ = 0;
};

/// Time that passes only by waiting, for simulations as fast as the processor allows.
class StepClock : public Clock {
public:
    double now() noexcept override { return time_; }
    void wait_until(double time) noexcept override { time_ = time > time_ ? time : time_; }

private:
    double time_ = 0;
};

/// A histogram of the lateness or duration of ticks, in steps of 10 % from 20 ns to 150 s: it stores no single tick, but counts
/// all.
class Lateness {
public:
    void add(double seconds) noexcept;
    void add(const Lateness& other) noexcept;
    std::uint64_t ticks() const noexcept { return ticks_; }
    /// s; that share of the ticks was not later (to 10 %).
    double quantile(double share) const noexcept;

private:
    static constexpr std::size_t kSteps = 240;
    std::array<std::uint64_t, kSteps> counts_{};
    std::uint64_t ticks_ = 0;
};

struct LoopReport {
    Lateness lateness;  ///< after the moment when the tick was due
    std::uint64_t long_periods =
        0;  ///< over 1.25 ms at 1 kHz (800 Hz, the least that the paper reached), 5/4 of a period at others
    double seconds = 0;
};

/// Calls `tick` with the measured seconds since the last call, until it returns false. A missed tick is not made up for: the next
/// is due at the next beat.
LoopReport run_loop(Clock& clock, double rate, const std::function<bool(double dt)>& tick);

}  // namespace tactics
