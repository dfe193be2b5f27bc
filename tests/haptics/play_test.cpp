// SPDX-License-Identifier: Apache-2.0
// From what a mouse tells to the force on the finger: never wrong, never late, never more memory.
#include "tactics/haptics/loop/play.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/loop/loop.h"
#include "tactics/haptics/scenes/relief_scene.h"
#include "tests/haptics/allocations.h"

namespace tactics::play_test {
namespace {

HeightMap terrain() {
    HeightMap map{160, 80, 0.5, {}};
    map.heights.resize(160 * 80);
    for (int j = 0; j < 80; ++j)
        for (int i = 0; i < 160; ++i) map.at(i, j) = static_cast<float>(5 + 3 * std::sin(i * 0.1) * std::cos(j * 0.08));
    return map;
}

struct Ended {
    std::vector<TickRecord> records;
    unsigned too_late = 0;
};

Ended play_on(const HeightMap& map, HapticDevice& device, const ReliefFeel& feel) {
    const ReliefSurface surface(map);
    ReliefScene scene(surface, feel);
    Playing play(scene, nullptr, {});
    StepClock clock;
    HapticSample sample;
    run_loop(clock, 1000, [&](double dt) {
        if (device.read(sample, dt) != HapticDevice::State::fine) return false;
        return device.push(play.tick(sample, dt));
    });
    return {play.recorder().records(), play.safety().too_late()};
}

TEST(Playing, LiftsTheFingerOverATerrain) {
    const HeightMap map = terrain();
    const auto mouse = simulated_mouse(kLevers[0].lever, kFingers[1].finger, map.width(), map.height(), 5, 50, 4);
    const Ended ended = play_on(map, *mouse, {});
    ASSERT_GT(ended.records.size(), 3990u);
    EXPECT_EQ(ended.too_late, 0u);
    // Once the soft start is over the finger sinks in by no more than its load needs: 1 N, the lever and friction at 1 N/mm.
    for (const TickRecord& one : ended.records)
        if (one.time > 1) {
            ASSERT_LT(one.surface - one.finger, 2.5) << one.time;
            ASSERT_LT(one.finger - one.surface, 1.5) << one.time;
        }
}

// The hand brakes with 2.5 m/s2 and stops that many mm before a block of 40 mm. The mouse reports only positions, so the play
// must estimate the speed of the hand.
double bump_before_a_block(double speed, double before) {
    constexpr double kPitch = 0.1, kFloor = 8, kTop = 48, kEdge = 30, kRun = 8, kBraking = 2500, kRest = 0.8, kTick = 0.0005;
    HeightMap map{600, 4, kPitch, {}};
    for (int i = 0; i < 600 * 4; ++i) map.heights.push_back(static_cast<float>(i % 600 * kPitch < kEdge ? kFloor : kTop));
    const double stop = kEdge - kPitch / 2 - before;
    std::string hand = "0," + std::to_string(stop - kRun) + ",0.2\n";
    double x = stop - kRun;
    for (double time = kRest; time < kRest + kRun / speed + 0.6; time += kTick) {
        hand += std::to_string(time) + "," + std::to_string(x) + ",0.2\n";
        x += std::min(speed, std::sqrt(2 * kBraking * std::max(0.0, stop - x))) * kTick;
    }
    ReliefFeel feel;
    feel.edges.force_per_speed = 0;
    feel.wall.lever.delay = 0.001;
    feel.wall.law.damping_ns_per_m = 0.5;
    feel.wall.finger = kFingers[1].finger;
    const auto mouse = recorded_mouse(hand, "hand", feel.wall.lever, feel.wall.finger, kFloor);
    double bump = 0;
    for (const TickRecord& one : play_on(map, *mouse, feel).records)
        if (one.time > kRest) bump = std::max(bump, one.finger - kFloor);
    return bump;
}

TEST(Playing, AHandThatStopsBeforeAWallFeelsNone) {
    for (const double speed : {25.0, 50.0, 75.0, 100.0}) {
        EXPECT_LT(bump_before_a_block(speed, 1), 0.2) << speed;
        EXPECT_LT(bump_before_a_block(speed, 0.5), 0.5) << speed;
        EXPECT_LT(bump_before_a_block(speed, 0.1), 3) << speed;
    }
}

TEST(Playing, ForceIsFiniteWhateverIsTold) {
    const ReliefSurface surface(terrain());
    ReliefScene scene(surface, {});
    const PlaySettings settings;
    Playing play(scene, nullptr, settings);
    std::mt19937 random(3);
    const double odd[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 0, 12, 40, 1e9, -3};
    const auto any = [&] { return odd[random() % 8]; };
    for (int i = 0; i < 100'000; ++i) {
        HapticSample sample;
        sample.knows_place = true;
        sample.place = {any(), any()};
        sample.height = any();
        const double force = play.tick(sample, random() % 10 == 0 ? any() : 0.001).z;
        ASSERT_TRUE(std::isfinite(force));
        ASSERT_LE(std::abs(force), settings.safety.most_force);
    }
}

// Answers what nothing should ever be given.
class Mad final : public Scene {
public:
    Felt feel(const Touch&, double) noexcept override {
        const double answers[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e9, 8, -8, 0};
        return {{answers[random_() % 7], answers[random_() % 7], answers[random_() % 7]}, std::nan(""), 1e300};
    }
    void begin_again() noexcept override {}

private:
    std::mt19937 random_{7};
};

TEST(Playing, ForceIsBoundedWhateverASceneAnswers) {
    Mad scene;
    const PlaySettings settings;
    Playing play(scene, nullptr, settings);
    HapticSample sample;
    sample.knows_place = true;
    Point3 before;
    for (int i = 0; i < 100'000; ++i) {
        const Point3 force = play.tick(sample, 0.001);
        ASSERT_TRUE(is_finite(force));
        ASSERT_LE(length_of(force), settings.safety.most_force + 1e-9);
        ASSERT_LE(length_of(force - before), settings.safety.most_slew * 0.001 + 1e-9);
        before = force;
    }
}

TEST(Playing, StopKeyAndFaultLetGo) {
    const ReliefSurface surface(terrain());
    ReliefScene scene(surface, {});
    Playing play(scene, nullptr, {});
    HapticSample sample;
    sample.knows_place = true;
    sample.place = {20, 20};
    sample.height = 2;  // deep in it
    for (int i = 0; i < 1000; ++i) play.tick(sample, 0.001);
    EXPECT_GT(play.tick(sample, 0.001).z, 1);
    sample.fault = true;
    for (int i = 0; i < 5; ++i) play.tick(sample, 0.001);
    EXPECT_EQ(play.tick(sample, 0.001).z, 0);
    sample.fault = false;
    for (int i = 0; i < 500; ++i) play.tick(sample, 0.001);
    EXPECT_GT(play.tick(sample, 0.001).z, 1);
    sample.stop_key = true;
    play.tick(sample, 0.001);
    sample.stop_key = false;
    for (int i = 0; i < 5; ++i) play.tick(sample, 0.001);
    EXPECT_EQ(play.tick(sample, 0.001).z, 0);
    EXPECT_TRUE(play.stopped());
}

TEST(Playing, ATickTakesNoMemory) {
    if (!tests::counts_allocations()) GTEST_SKIP() << "sanitizers count for themselves";
    const HeightMap map = terrain();
    for (const WallMethod method :
         {WallMethod::raw, WallMethod::steps, WallMethod::governor, WallMethod::look_ahead, WallMethod::slope}) {
        const ReliefSurface surface(map);
        const auto fusion = learning_fusion({});
        ReliefFeel feel;
        feel.wall.method = method;
        ReliefScene scene(surface, feel);
        PlaySettings settings;
        settings.most_records = 500;
        Playing play(scene, fusion.get(), settings);
        HapticSample sample;
        const std::size_t before = tests::allocations();
        for (int i = 0; i < 2000; ++i) {
            sample.moved = {i * 0.001, {0.05, 0}, {0.05, 0}};
            sample.has_overlay = i % 16 == 0;
            sample.overlay = {i * 0.001, {i * 0.05, 20}};
            sample.height = 5;
            play.tick(sample, 0.001);
        }
        EXPECT_EQ(tests::allocations(), before);
    }
    const std::size_t before = tests::allocations();
    const std::vector<int> some(static_cast<std::size_t>(map.columns), 3);
    EXPECT_EQ(some.back(), 3);
    EXPECT_GT(tests::allocations(), before);
}

TEST(RecordedMouse, RepeatsItsWay) {
    const std::string csv = "time_s,x_mm,y_mm,finger_mm\n5,10,20,3\n6,20,20,4\n\n# a pause\n7,20,40,6\n";
    const auto mouse = recorded_mouse(csv, "way.csv", {}, {}, 0);
    HapticSample sample;
    ASSERT_EQ(mouse->read(sample, 0), HapticDevice::State::fine);
    EXPECT_EQ(sample.place.x, 10);
    ASSERT_EQ(mouse->read(sample, 0.5), HapticDevice::State::fine);
    EXPECT_NEAR(sample.place.x, 15, 1e-9);
    EXPECT_NEAR(sample.height, 3.5, 1e-9);
    ASSERT_EQ(mouse->read(sample, 1), HapticDevice::State::fine);
    EXPECT_NEAR(sample.place.y, 30, 1e-9);
    EXPECT_NEAR(sample.height, 5, 1e-9);
    EXPECT_EQ(mouse->read(sample, 1), HapticDevice::State::over);
}

TEST(RecordedMouse, SaysWhatIsWrongAndWhere) {
    const auto message = [](const std::string& csv) -> std::string {
        try {
            recorded_mouse(csv, "way.csv", {}, {}, 0);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("time_s,x_mm,y_mm\n0,1,2\n1,here,2\n"),
              "way.csv:3: a line is time_s,x_mm,y_mm, all of them numbers, for example 0.001,12.5,40");
    EXPECT_EQ(message("0,1,2\n2,1,2\n1,1,2\n"), "way.csv:3: time goes back here; sort the lines by their time");
    EXPECT_EQ(message("time_s,x_mm,y_mm\n"), "way.csv: a way has at least two moments; a line is time_s,x_mm,y_mm");
    EXPECT_EQ(message("0,1\n"), "way.csv:1: a line is time_s,x_mm,y_mm, all of them numbers, for example 0.001,12.5,40");
    EXPECT_EQ(message("0,1,2"), "way.csv: a way has at least two moments; a line is time_s,x_mm,y_mm");
    EXPECT_EQ(message("0,1,2\n1,1,2"), "");
}

}  // namespace
}  // namespace tactics::play_test
