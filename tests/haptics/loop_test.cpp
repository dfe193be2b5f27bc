// SPDX-License-Identifier: Apache-2.0
// The beat of the loop, on a clock that is moved by hand.
#include "tactics/haptics/loop/loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tactics/haptics/loop/recorder.h"

namespace tactics::loop_test {
namespace {

class HandClock : public Clock {
public:
    double time = 100;
    double late = 0;  // of each waking
    double now() noexcept override { return time; }
    void wait_until(double due) noexcept override { time = std::max(time, due + late); }
};

TEST(Loop, TicksAtItsRate) {
    HandClock clock;
    clock.late = 20e-6;
    int ticks = 0;
    double sum = 0;
    const LoopReport report = run_loop(clock, 1000, [&](double dt) {
        sum += dt;
        return ++ticks < 5000;
    });
    EXPECT_NEAR(sum, 5, 1e-3);
    EXPECT_EQ(report.lateness.ticks(), 5000u);
    EXPECT_NEAR(report.lateness.quantile(0.5), 20e-6, 2.5e-6);
    EXPECT_EQ(report.long_periods, 0u);
}

TEST(Loop, WhatWasMissedIsNotMadeUpFor) {
    HandClock clock;
    int ticks = 0;
    double longest = 0;
    const LoopReport report = run_loop(clock, 1000, [&](double dt) {
        longest = std::max(longest, dt);
        if (ticks == 10) clock.time += 0.0205;  // one tick takes 20 periods
        return ++ticks < 100;
    });
    EXPECT_NEAR(longest, 0.021, 1e-6);  // told as it was, to the next beat
    EXPECT_NEAR(report.seconds, 0.120, 1e-6);
    EXPECT_EQ(report.long_periods, 1u);
}

TEST(Loop, LatenessKeepsItsQuantiles) {
    Lateness lateness;
    for (int i = 1; i <= 10'000; ++i) lateness.add(i * 1e-6);
    for (const double share : {0.1, 0.5, 0.99, 0.999})
        EXPECT_NEAR(lateness.quantile(share) / (share * 0.01), 1.05, 0.06) << share;
    lateness.add(-1);
    lateness.add(1e9);
    lateness.add(std::nan(""));
    EXPECT_EQ(lateness.ticks(), 10'003u);
}

TEST(Loop, SteppedTimeIsExact) {
    StepClock clock;
    int ticks = 0;
    double most = 0;
    run_loop(clock, 1000, [&](double dt) {
        most = std::max(most, std::abs(dt - 0.001));
        return ++ticks < 10'000;
    });
    EXPECT_LT(most, 1e-9);
}

TEST(Loop, ByTheWallAMillisecondIsOne) {
    MonotonicClock clock(false);
    const double begin = clock.now();
    int ticks = 0;
    run_loop(clock, 1000, [&](double) { return ++ticks < 50; });
    EXPECT_GE(clock.now() - begin, 0.0495);  // how late it may be is the machine's affair
}

TEST(Recorder, KeepsTheLastInTheirOrder) {
    Recorder recorder(3);
    EXPECT_TRUE(recorder.records().empty());
    for (int i = 0; i < 2; ++i) recorder.add({0.001 * i, {1.0 * i, 0}, 0, 0, 0, {}});
    ASSERT_EQ(recorder.records().size(), 2u);
    EXPECT_FALSE(recorder.lost());
    for (int i = 2; i < 7; ++i) recorder.add({0.001 * i, {1.0 * i, 0}, 0, 0, 0, {0, 0, -0.5}});
    const auto records = recorder.records();
    ASSERT_EQ(records.size(), 3u);
    EXPECT_EQ(records[0].at.x, 4);
    EXPECT_EQ(records[2].at.x, 6);
    EXPECT_TRUE(recorder.lost());
    std::string csv = csv_header({});
    add_csv(csv, records[2], {});
    EXPECT_EQ(csv, "time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n\n0.006,6,0,0,0,0,-0.5\n");
    EXPECT_EQ(recorder.at(6).time, records[2].time);
}

}  // namespace
}  // namespace tactics::loop_test
