// SPDX-License-Identifier: Apache-2.0
// The haptic mouse in a second simulation, of the same numbers by other means: Runge and Kutta of the fourth order where
// lever.cpp goes half implicitly, forces looked up by their time where that keeps a queue, friction as a smooth law where that
// catches the lever. A play is told places alone, as by a mouse, and has to find out velocities itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/loop/loop.h"
#include "tactics/haptics/loop/play.h"
#include "tactics/haptics/scenes/relief_scene.h"
#include "tactics/haptics/scenes/stability.h"

namespace tactics::second_simulation_test {
namespace {

constexpr double kTick = 0.001, kStep = 25e-6;  // s

class SecondLever {
public:
    SecondLever(const LeverSettings& lever, const FingerSettings* finger, double height) : lever_(lever), finger_(finger) {
        now_ = {height, 0, 0, 0, 0};
        if (finger_ == nullptr) return;
        now_[2] = height - finger_->preload / finger_->pad_stiffness;
        now_[4] = now_[2] - finger_->preload / finger_->stiffness;
    }
    double height() const { return now_[0]; }
    double counted() const { return std::round(now_[0] / lever_.encoder_step) * lever_.encoder_step; }
    void tick(double force) {
        forces_.push_back(std::clamp(force, -lever_.most_force, lever_.most_force));
        const int steps = static_cast<int>(std::lround(kTick / kStep));
        for (int i = 0; i < steps; ++i) {
            const double since = static_cast<double>(forces_.size() - 1) + (i + 0.5) / steps - lever_.delay / kTick;
            step(since < 0 ? 0 : forces_[static_cast<std::size_t>(since)]);
        }
    }

private:
    using State = std::array<double, 5>;  // lever: mm, mm/s; fingertip: mm, mm/s; far end of its spring: mm
    State slope(const State& s, double force) const {
        const auto [z, v, x, u, far] = s;
        double pad = 0, spring = 0;
        if (finger_ != nullptr) {
            if (z > x) pad = std::max(0.0, finger_->pad_stiffness * (z - x) + finger_->pad_damping_ns_per_m * (v - u) / 1000);
            spring = finger_->stiffness * (x - far) + finger_->damping_ns_per_m * u / 1000;
        }
        constexpr double kSlow = 0.5;              // mm/s below which friction lessens
        const double mass = lever_.mass_g * 1e-6;  // N per mm/s2
        const double up = force - pad - mass * 1000 * lever_.gravity_m_per_s2 - lever_.damping_ns_per_m * v / 1000 -
                          lever_.friction * std::tanh(v / kSlow);
        if (finger_ == nullptr) return {v, up / mass, 0, 0, 0};
        return {v, up / mass, u, (pad - spring) / (finger_->mass_g * 1e-6),
                (x - finger_->preload / finger_->stiffness - far) / finger_->relaxation};
    }
    void step(double force) {
        const auto on = [this](const State& by, double time) {
            State there = now_;
            for (std::size_t i = 0; i < there.size(); ++i) there[i] += by[i] * time;
            return there;
        };
        const State a = slope(now_, force), b = slope(on(a, kStep / 2), force), c = slope(on(b, kStep / 2), force),
                    d = slope(on(c, kStep), force);
        for (std::size_t i = 0; i < now_.size(); ++i) now_[i] += kStep / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        if (now_[0] >= lever_.lowest && now_[0] <= lever_.highest) return;
        now_[0] = std::clamp(now_[0], lever_.lowest, lever_.highest);
        now_[1] = 0;
    }
    LeverSettings lever_;
    const FingerSettings* finger_;
    State now_{};
    std::vector<double> forces_;
};

// How far it swings in the last half second of three seconds, after it fell onto a surface and after a small push.
double swing(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger) {
    double widest = 0;
    for (const double begin : {34.0, 29.3}) {
        SecondLever mouse(lever, finger, begin);
        double before = mouse.counted(), least = 1e9, most = -1e9;
        for (int tick = 0; tick < 3000; ++tick) {
            const double now = mouse.counted();
            mouse.tick(force(law, 30, now, before, kTick));
            before = now;
            if (tick < 2500) continue;
            least = std::min(least, mouse.height());
            most = std::max(most, mouse.height());
        }
        widest = std::max(widest, most - least);
    }
    return widest;
}

TEST(SecondSimulation, WhatIsBorneComesToRestWithAndWithoutAFingerWhateverTheFriction) {
    const std::vector<FingerSettings> all = {kFingers[0].finger, kFingers[1].finger, kFingers[2].finger};
    for (const double mass : {30.0, 100.0})
        for (const double delay : {0.0, 0.001, 0.0015})
            for (const double damping : {1.0, 3.0}) {
                LeverSettings lever;
                lever.mass_g = mass;
                lever.delay = delay;
                const double most = borne_stiffness(damping, DampingSign::corrected, lever, all);
                ASSERT_GT(most, 0) << mass << " " << delay;
                for (const double friction : {0.0, 0.01}) {
                    lever.friction = friction;
                    EXPECT_LT(swing({0.9 * most, damping}, lever, nullptr), 0.15) << mass << " " << delay << " " << damping;
                    for (const FingerSettings& finger : all)
                        EXPECT_LT(swing({0.9 * most, damping}, lever, &finger), 0.15) << mass << " " << delay << " " << damping;
                }
                // What swings is not borne.
                lever.friction = 0;
                EXPECT_GT(swing({3 * most, damping}, lever, nullptr), 0.2) << mass << " " << delay << " " << damping;
            }
}

// A hand on its way over a block or to a stop before it.
struct Met {
    double over = 0, half = 0, bump = 0;  // mm
};
constexpr double kPitch = 0.1, kFloor = 8, kTop = 48, kEdge = 30, kRun = 8, kRest = 0.8;

std::string hand(double speed, double before) {
    constexpr double kBraking = 2500, kEach = 0.0005;
    const double stop = before < 0 ? 1e9 : kEdge - kPitch / 2 - before;
    double x = std::min(stop, kEdge) - kRun;
    std::string way = "0," + std::to_string(x) + ",0.2\n";
    for (double time = kRest; time < kRest + kRun / speed + 0.6; time += kEach) {
        way += std::to_string(time) + "," + std::to_string(x) + ",0.2\n";
        x += std::min(speed, std::sqrt(2 * kBraking * std::max(0.0, stop - x))) * kEach;
    }
    return way;
}

Met met(const std::vector<TickRecord>& records) {
    Met met;
    bool half = false;
    for (const TickRecord& one : records) {
        if (one.time < kRest) continue;
        met.over = std::max(met.over, one.finger - kTop);
        met.bump = std::max(met.bump, one.finger - kFloor);
        if (!half && one.finger >= (kFloor + kTop) / 2) {
            half = true;
            met.half = one.at.x - kEdge;
        }
    }
    return met;
}

// The place is that of the recorded mouse; the height that of `second`, or its own if there is none.
std::vector<TickRecord> play(const ReliefFeel& feel, const std::string& way, SecondLever* second) {
    HeightMap map{600, 4, kPitch, {}};
    for (int i = 0; i < 600 * 4; ++i) map.heights.push_back(static_cast<float>(i % 600 * kPitch < kEdge ? kFloor : kTop));
    const ReliefSurface surface(map);
    ReliefScene scene(surface, feel);
    Playing play(scene, nullptr, {});
    const auto mouse = recorded_mouse(way, "hand", feel.wall.lever, feel.wall.finger, kFloor);
    StepClock clock;
    HapticSample sample;
    run_loop(clock, 1000, [&](double dt) {
        if (mouse->read(sample, dt) != HapticDevice::State::fine) return false;
        if (second != nullptr) sample.height = second->counted();
        const Point3 force = play.tick(sample, dt);
        if (second != nullptr) second->tick(force.z);
        return mouse->push(force);
    });
    return play.recorder().records();
}

TEST(SecondSimulation, FeelsTheWallsOfTheFirst) {
    const std::vector<FingerSettings> all = {kFingers[0].finger, kFingers[1].finger, kFingers[2].finger};
    for (const WallMethod method : {WallMethod::look_ahead, WallMethod::steps})
        for (const NamedLever& lever : kLevers)
            for (const FingerSettings& finger : all)
                for (const double speed : {25.0, 100.0})
                    for (const double before : {-1.0, 0.5}) {
                        ReliefFeel feel;
                        feel.edges.force_per_speed = 0;
                        feel.wall.method = method;
                        feel.wall.lever = lever.lever;
                        feel.wall.lever.delay = 0.001;
                        feel.wall.law.damping_ns_per_m = check_stable({1, 1}, feel.wall.lever, all).damping_ns_per_m;
                        feel.wall.finger = finger;
                        SecondLever second(feel.wall.lever, &finger, kFloor);
                        const Met first = met(play(feel, hand(speed, before), nullptr)),
                                  other = met(play(feel, hand(speed, before), &second));
                        const auto what = std::string(lever.name) + ", " + std::to_string(finger.stiffness) + " N/mm, " +
                                          std::to_string(speed) + " mm/s, " + std::to_string(before);
                        if (before < 0) {
                            EXPECT_NEAR(first.over, other.over, 0.3) << what;
                            EXPECT_NEAR(first.half, other.half, 0.2) << what;
                        } else {
                            EXPECT_NEAR(first.bump, other.bump, 0.5) << what;
                        }
                    }
}

}  // namespace
}  // namespace tactics::second_simulation_test
