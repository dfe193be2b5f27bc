// SPDX-License-Identifier: Apache-2.0
// A way of three coordinates, played again as an arm; and a log of a play, played again.
#include "tactics/haptics/devices/recorded_way.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tactics/error.h"
#include "tactics/haptics/devices/arm_devices.h"
#include "tactics/haptics/devices/mouse_devices.h"
#include "tactics/haptics/loop/recorder.h"

namespace tactics::recorded_way_test {
namespace {

using State = HapticDevice::State;

TEST(RecordedArm, RepeatsItsWayInSpace) {
    const auto arm = recorded_arm("x_mm,y_mm,z_mm,time_s\n10,20,3,5\n20,20,-4,6\n20,40,-4,7\n", "way.csv");
    HapticSample sample;
    ASSERT_EQ(arm->read(sample, 0), State::fine);
    EXPECT_TRUE(sample.knows_place);
    EXPECT_EQ(sample.place.x, 10);
    EXPECT_EQ(sample.height, 3);
    ASSERT_TRUE(arm->push({5, 5, 5}));  // which moves nothing
    ASSERT_EQ(arm->read(sample, 0.5), State::fine);
    EXPECT_NEAR(sample.place.x, 15, 1e-9);
    EXPECT_NEAR(sample.height, -0.5, 1e-9);
    ASSERT_EQ(arm->read(sample, 1), State::fine);
    EXPECT_NEAR(sample.place.y, 30, 1e-9);
    EXPECT_EQ(sample.height, -4);
    EXPECT_EQ(arm->read(sample, 1), State::over);
    EXPECT_FALSE(arm->is_real());
}

TEST(RecordedArm, AMouseTakesItsHeightAsTheFingers) {
    const auto mouse = recorded_mouse("time_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,1,2,5\n", "way.csv", {}, {}, 0);
    HapticSample sample;
    mouse->read(sample, 0.5);
    EXPECT_NEAR(sample.height, 4, 1e-9);
}

TEST(RecordedArm, SaysWhatIsWrong) {
    const auto message = [](const std::string& csv) -> std::string {
        try {
            recorded_arm(csv, "way.csv");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("time_s,x_mm,y_mm\n0,1,2\n1,1,2\n"),
              "way.csv: for an arm a way has three coordinates; its first line is time_s,x_mm,y_mm,z_mm");
    EXPECT_EQ(message("time_s,x_mm,y_mm,z_mm,finger_mm\n0,1,2,3,3\n1,1,2,3,3\n"),
              "way.csv:1: z_mm and finger_mm are both the height of the finger; leave out one of them");
    EXPECT_EQ(message("time_s,x_mm,y_mm,z_mm\n0,1,2,1e6\n1,1,2,3\n"),
              "way.csv:2: 1e6 is beyond 100000; times are in s and lengths in mm");
    EXPECT_EQ(message("time_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,1,2,3\n"), "");
}

// To what a log rounds: 0.1 um.
TEST(RecordedArm, WhatAPlayHasLoggedIsPlayedAgain) {
    const auto place = [](double t) { return Point3{40 + 30 * std::cos(7 * t), 30 * std::sin(5 * t), 3 * std::sin(11 * t) - 1}; };
    const TickColumns columns{.truth = false, .spatial = true};
    std::string csv = csv_header(columns);
    for (int i = 0; i <= 1000; ++i) {
        const Point3 at = place(0.001 * i);
        add_csv(csv, {0.001 * i, {at.x, at.y}, at.z, 1, 2, {0.1, 0.2, 0.3}, kNoPlace}, columns);
    }
    const auto arm = recorded_arm(csv, "ticks.csv");
    const auto mouse = recorded_mouse(csv, "ticks.csv", {}, {}, 0);
    for (int i = 0; i < 1000; ++i) {
        HapticSample as_arm, as_mouse;
        ASSERT_EQ(arm->read(as_arm, i == 0 ? 0 : 0.001), State::fine);
        ASSERT_EQ(mouse->read(as_mouse, i == 0 ? 0 : 0.001), State::fine);
        const Point3 at = place(0.001 * i);
        EXPECT_NEAR(as_arm.place.x, at.x, 1e-4);
        EXPECT_NEAR(as_arm.place.y, at.y, 1e-4);
        EXPECT_NEAR(as_arm.height, at.z, 1e-4);
        EXPECT_EQ(as_arm.place.x, as_mouse.place.x);
        EXPECT_EQ(as_arm.place.y, as_mouse.place.y);
        EXPECT_EQ(as_arm.height, as_mouse.height);
    }
}

}  // namespace
}  // namespace tactics::recorded_way_test
