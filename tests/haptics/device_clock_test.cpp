// SPDX-License-Identifier: Apache-2.0
// The clock of a device on ours: jitter, drift, running over, restarts; and what is left of it where the finger is.
#include "tactics/haptics/sensing/device_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tactics/haptics/simulated/pointing.h"
#include "tactics/measure/random.h"

namespace tactics::device_clock_test {
namespace {

constexpr double kLateness = 0.003;  // s, of arrivals, at most

// A device that sends a thousand times a second; what it sends arrives by chance up to 3 ms late, and in order.
struct Device {
    double drift = 0;  // s a s, of its clock against ours
    double first = 0;  // us, when our clock is at 0
    double now = 0;    // s, our clock
    double arrived = 0;
    RandomNumbers chance{5};

    std::uint32_t microseconds() const {
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(std::llround(first + 1e6 * now * (1 + drift))));
    }
    double arrival() { return arrived = std::max(arrived, now + kLateness * chance.uniform()); }
};

// The worst that is told from `learned` s on, early and late.
struct Wrong {
    double early = 0, late = 0;
};
Wrong worst_of(Device& device, DeviceClock& clock, double from, double to, double learned) {
    Wrong wrong;
    double before = -1e9;
    for (device.now = from; device.now < to; device.now += 0.001) {
        const double told = clock.time(device.microseconds(), device.arrival());
        EXPECT_GT(told, before) << device.now;
        before = told;
        if (device.now < learned) continue;
        wrong.early = std::max(wrong.early, device.now - told);
        wrong.late = std::max(wrong.late, told - device.now);
    }
    return wrong;
}

TEST(DeviceClock, JitterOfArrivalIsGone) {
    Device device;
    DeviceClock clock;
    const Wrong wrong = worst_of(device, clock, 100, 160, 101);
    EXPECT_LT(wrong.early, 1e-5);
    EXPECT_LT(wrong.late, 3e-4);  // it creeps up from one quick arrival to the next
}

TEST(DeviceClock, FollowsAQuartz) {
    for (const double drift : {-1e-4, 1e-4}) {
        Device device;
        device.drift = drift;
        DeviceClock clock;
        const Wrong wrong = worst_of(device, clock, 10, 610, 12);
        EXPECT_LT(wrong.early, 1e-4) << drift;
        EXPECT_LT(wrong.late, 4e-4) << drift;
    }
}

TEST(DeviceClock, RunsOver) {
    Device device;
    device.first = 4294967296.0 - 20e6;
    DeviceClock clock;
    const Wrong wrong = worst_of(device, clock, 10, 60, 12);
    EXPECT_LT(wrong.early, 1e-4);
    EXPECT_LT(wrong.late, 3e-4);
}

TEST(DeviceClock, ADeviceThatBeginsAgain) {
    // Its clock at 0, far behind, ahead, or anywhere after a pause in which it ran over.
    for (const double first : {-100e6, -101e6 + 50, 3.0e6, 2000e6}) {
        Device device;
        DeviceClock clock;
        worst_of(device, clock, 50, 100, 51);
        device.first = first;
        const Wrong wrong = worst_of(device, clock, 101, 130, 103.5);
        EXPECT_LT(wrong.early, 1e-3) << first;
        EXPECT_LT(wrong.late, 3e-4) << first;
    }
}

TEST(DeviceClock, AnHourOfSilence) {
    Device device;
    DeviceClock clock;
    worst_of(device, clock, 1, 10, 2);
    const Wrong wrong = worst_of(device, clock, 5400, 5430, 5402.5);  // it ran over once meanwhile
    EXPECT_LT(wrong.early, 1e-3);
    EXPECT_LT(wrong.late, 3e-4);
}

// The program was held up for 2 s: of what came meanwhile the kernel has kept 64 reports, which are read at once.
TEST(DeviceClock, WhatWaitedIsNotTakenForNew) {
    Device device;
    DeviceClock clock;
    worst_of(device, clock, 10, 20, 11);
    for (device.now = 20; device.now < 20.064; device.now += 0.001)
        EXPECT_NEAR(clock.time(device.microseconds(), 22), device.now, 1e-3);
    const Wrong wrong = worst_of(device, clock, 22, 30, 22);
    EXPECT_LT(wrong.early, 1e-3);
    EXPECT_LT(wrong.late, 1e-3);
}

TEST(DeviceClock, ARepeatStandsStill) {
    DeviceClock clock;
    clock.time(5, 1);
    const double told = clock.time(1005, 1.001);
    EXPECT_EQ(clock.time(1005, 1.004), told);
    clock.restart();
    EXPECT_GT(clock.time(7, 1.0), told);
}

// A fusion that is told the times of such a device instead of the true ones.
class Retimed : public Fusion {
public:
    Retimed(std::unique_ptr<Fusion> fusion, double drift) : fusion_(std::move(fusion)) { device_.drift = drift; }
    void step(const OpticalStep& step) noexcept override {
        device_.now = step.time;
        fusion_->step({clock_.time(device_.microseconds(), device_.arrival()), step.first, step.second});
    }
    void overlay(const OverlaySample& sample) noexcept override { fusion_->overlay(sample); }
    Pose pose() const noexcept override { return fusion_->pose(); }
    unsigned resets() const noexcept override { return fusion_->resets(); }

private:
    std::unique_ptr<Fusion> fusion_;
    Device device_;
    DeviceClock clock_;
};

TEST(DeviceClock, WhereTheFingerIsSuffersNothing) {
    constexpr MouseGeometry kMouse{60, {10, -80}};
    for (const double drift : {-1e-4, 0.0, 1e-4}) {
        const Pointing pointing = straight_strokes(16, 250, 2500, 7);
        const Sensed sensed = sense(pointing, kMouse, all_causes(), 7);
        const PointingError good = pointing_error(*learning_fusion(kMouse), pointing, sensed, 4);
        Retimed retimed(learning_fusion(kMouse), drift);
        const PointingError error = pointing_error(retimed, pointing, sensed, 4);
        EXPECT_LT(error.rms, good.rms + 0.02) << drift;
        EXPECT_LT(error.overshoot, good.overshoot + 0.05) << drift;
        EXPECT_LT(error.worst_overshoot, good.worst_overshoot + 0.1) << drift;
        EXPECT_EQ(error.resets, good.resets) << drift;
    }
}

}  // namespace
}  // namespace tactics::device_clock_test
