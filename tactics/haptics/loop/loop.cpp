// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/loop.h"

#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace tactics {

namespace {

// Above the kernel's own threaded interrupts (50) there is nothing to win, and below 99 the watchdogs of the kernel keep their
// place.
constexpr int kPriority = 80;
constexpr double kLeast = 2e-8, kStep = 1.1;

}  // namespace

MonotonicClock::MonotonicClock(bool before_others) {
    slack_ = prctl(PR_GET_TIMERSLACK, 0, 0, 0, 0);
    prctl(PR_SET_TIMERSLACK, 1, 0, 0, 0);
    if (!before_others) return;
    mlockall(MCL_CURRENT | MCL_FUTURE);
    sched_param priority{};
    priority.sched_priority = kPriority;
    fifo_ = sched_setscheduler(0, SCHED_FIFO, &priority) == 0;
}

MonotonicClock::~MonotonicClock() {
    sched_param none{};
    if (fifo_) {
        sched_setscheduler(0, SCHED_OTHER, &none);
        munlockall();
    }
    if (slack_ > 0) prctl(PR_SET_TIMERSLACK, static_cast<unsigned long>(slack_), 0, 0, 0);
}

double MonotonicClock::now() noexcept {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void MonotonicClock::wait_until(double time) noexcept {
    if (!(time > 0)) return;
    timespec due{};
    due.tv_sec = static_cast<time_t>(std::floor(time));
    due.tv_nsec = std::clamp(static_cast<long>(std::lround((time - std::floor(time)) * 1e9)), 0L, 999'999'999L);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR) {
    }
}

void Lateness::add(double seconds) noexcept {
    ++ticks_;
    const double step = seconds > kLeast ? std::log(seconds / kLeast) / std::log(kStep) : 0;
    ++counts_[static_cast<std::size_t>(std::clamp(std::ceil(step), 0.0, static_cast<double>(kSteps - 1)))];
}

void Lateness::add(const Lateness& other) noexcept {
    for (std::size_t i = 0; i < kSteps; ++i) counts_[i] += other.counts_[i];
    ticks_ += other.ticks_;
}

double Lateness::quantile(double share) const noexcept {
    const double wanted = share * static_cast<double>(ticks_);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kSteps; ++i) {
        sum += counts_[i];
        if (static_cast<double>(sum) >= wanted) return i == 0 ? kLeast : kLeast * std::pow(kStep, static_cast<double>(i));
    }
    return 0;
}

LoopReport run_loop(Clock& clock, double rate, const std::function<bool(double dt)>& tick) {
    LoopReport report;
    const double period = 1 / rate, begin = clock.now();
    double last = begin;
    std::uint64_t beat = 1;
    for (;;) {
        const double due = begin + static_cast<double>(beat) * period;
        clock.wait_until(due);
        const double now = clock.now(), dt = now - last;
        report.lateness.add(now - due);
        if (dt > 1.25 * period) ++report.long_periods;
        last = now;
        if (!tick(dt)) break;
        beat = std::max(beat + 1, static_cast<std::uint64_t>(std::max(0.0, (clock.now() - begin) / period)) + 1);
    }
    report.seconds = clock.now() - begin;
    return report;
}

}  // namespace tactics
