// SPDX-License-Identifier: Apache-2.0
// A mouse that is played on: unplugged, silent, not permitted, on a clock that is moved by waiting.
#include "tactics/haptics/loop/play_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tactics/haptics/scenes/relief_scene.h"

namespace tactics::play_loop_test {
namespace {

// What it does is asked at each reading and opening, by the time.
class Pretended : public HapticDevice {
public:
    explicit Pretended(StepClock& clock) : clock_(clock) {}
    std::function<State(double time)> says = [](double) { return State::fine; };
    std::function<bool(double time, std::string& why)> opens = [](double, std::string&) { return true; };
    std::vector<double> forces, times;
    int let_go_at = -1;  // after this many forces

    State read(HapticSample& sample, double) noexcept override {
        const State state = says(clock_.now());
        sample.knows_place = true;
        sample.place = {10, 10};
        if (state == State::fine) sample.height = 2;  // 3 mm in it
        return state;
    }
    bool push(const Point3& force) noexcept override {
        forces.push_back(force.z);
        times.push_back(clock_.now());
        return true;
    }
    void let_go() noexcept override { let_go_at = static_cast<int>(forces.size()); }
    bool reopen(std::string& why) override {
        why.clear();
        return opens(clock_.now(), why);
    }
    // The greatest in that time.
    double most(double from, double to) const {
        double most = 0;
        for (std::size_t i = 0; i < forces.size(); ++i)
            if (times[i] > from && times[i] < to) most = std::max(most, std::abs(forces[i]));
        return most;
    }

private:
    StepClock& clock_;
};

class PlayLoopTest : public testing::Test {
protected:
    PlayLoopReport run(double seconds) {
        HeightMap map{40, 40, 1, std::vector<float>(1600, 5.0F)};
        const ReliefSurface surface(map);
        ReliefScene scene(surface, {});
        Playing play(scene, nullptr, {});
        const PlayLoop loop{1000, seconds, [] { return false; },
                            [this](DeviceNews what, const std::string& why) {
                                const char* names[] = {"gone", "refused ", "silent", "back"};
                                news += names[static_cast<int>(what)] + why + "\n";
                            }};
        const PlayLoopReport report = run_play(loop, clock, mouse, play);
        records = play.recorder().records();
        return report;
    }
    StepClock clock;
    Pretended mouse{clock};
    std::string news;
    std::vector<TickRecord> records;
};

using State = HapticDevice::State;

TEST_F(PlayLoopTest, SilenceIsNoForceAndIsToldOnce) {
    mouse.says = [](double time) { return time > 1 && time < 6 ? State::nothing : State::fine; };
    run(8);
    EXPECT_GT(mouse.most(0.9, 1), 2.9);
    EXPECT_EQ(mouse.most(1.0055, 6), 0);
    EXPECT_EQ(news, "silent\nback\n");
    // Begun softly: 8 N in 0.3 s.
    EXPECT_LT(mouse.most(6, 6.05), 1.5);
    EXPECT_GT(mouse.most(6, 6.05), 0.5);
    EXPECT_GT(mouse.most(7, 8), 2.9);
    EXPECT_EQ(mouse.forces.back(), 0);
    EXPECT_EQ(mouse.let_go_at, static_cast<int>(mouse.forces.size()));
}

TEST_F(PlayLoopTest, AMissingWordOrTwoIsNotFelt) {
    int reads = 0;
    mouse.says = [&](double) { return ++reads % 3 == 0 ? State::fine : State::nothing; };
    run(2);
    EXPECT_GT(mouse.most(1, 2), 2.9);
    for (std::size_t i = 1000; i + 10 < mouse.forces.size(); ++i) ASSERT_GT(mouse.forces[i], 2.9);
}

TEST_F(PlayLoopTest, NothingIsPlayedBeforeTheFirstWord) {
    mouse.says = [](double time) { return time < 0.5 ? State::nothing : State::fine; };
    run(1);
    EXPECT_GT(mouse.times.front(), 0.499);
    EXPECT_EQ(records.size(), mouse.forces.size());
    EXPECT_EQ(news, "");
}

TEST_F(PlayLoopTest, OneThatNeverSaysAWordHasAnEnd) {
    mouse.says = [](double) { return State::nothing; };
    run(3);
    EXPECT_TRUE(mouse.forces.empty());
    EXPECT_EQ(news, "silent\n");
}

TEST_F(PlayLoopTest, UnpluggedItIsWaitedForAndBeginsFromZero) {
    mouse.says = [](double time) { return time > 1 && time < 2 ? State::gone : State::fine; };
    mouse.opens = [](double time, std::string&) { return time > 2.1; };
    const PlayLoopReport report = run(4);
    EXPECT_EQ(report.gone, 1u);
    EXPECT_EQ(news, "gone\nback\n");
    EXPECT_GT(mouse.most(0.9, 1), 2.9);
    EXPECT_EQ(mouse.most(1.001, 2.1), 0);
    EXPECT_LT(mouse.most(2.1, 2.25), 8 * 0.16 / 0.3);
    EXPECT_LT(mouse.most(2.1, 2.21), 0.4);
    EXPECT_GT(mouse.most(3, 4), 2.9);
    EXPECT_NEAR(clock.now(), 4, 0.01);
    EXPECT_NEAR(records.back().time, 4, 0.01);  // the log has the time that it was away
}

TEST_F(PlayLoopTest, WhatTheKernelStillHasIsNotBack) {
    mouse.says = [](double time) { return time > 1 && time < 2 ? State::gone : State::fine; };
    const PlayLoopReport report = run(3);
    EXPECT_EQ(report.gone, 1u);
    EXPECT_EQ(news, "gone\nback\n");
}

TEST_F(PlayLoopTest, UnpluggedForGoodItIsOverInTime) {
    mouse.says = [](double time) { return time > 1 ? State::gone : State::fine; };
    mouse.opens = [](double, std::string&) { return false; };
    run(3);
    EXPECT_EQ(news, "gone\n");
    EXPECT_NEAR(clock.now(), 3, 0.25);
}

TEST_F(PlayLoopTest, ThatItMayNotBeUsedIsToldOnceUdevHasHadItsTime) {
    mouse.says = [](double time) { return time > 1 && time < 2 ? State::gone : State::fine; };
    // Two glimpses, and then for long.
    mouse.opens = [](double time, std::string& why) {
        if (time < 2 || (time > 3 && time < 7)) why = "not permitted";
        return time > 7;
    };
    run(9);
    EXPECT_EQ(news, "gone\nrefused not permitted\nback\n");
}

}  // namespace
}  // namespace tactics::play_loop_test
