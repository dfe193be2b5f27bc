// SPDX-License-Identifier: Apache-2.0
// `tactics play` with a haptic mouse simulated by umockdev: whatever the mouse does, the finger is not hurt. Tests end after a
// number of reports, not seconds, and do not check the strength of a force: on a busy machine ticks are late, and the force
// begins softly again and again.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tactics/units.h"
#include "tests/cli/picture.h"
#include "tests/cli/tool.h"
#include "tests/haptics/firmware.h"

namespace tactics::play_mouse_test {
namespace {

using namespace tests;

// A report written by the program, with the numbers of good reports and of all reports it had received.
struct Written {
    long good = 0, given = 0;
    ForceWord word;
};

struct Played {
    Ending ending;
    std::vector<Written> before, after;      // it was away
    std::vector<std::vector<double>> ticks;  // of --csv
};

constexpr std::size_t kTime = 0, kFinger = 3, kSurface = 4, kForce = 6;

class PlayMouse : public testing::Test {
protected:
    void SetUp() override {
#ifndef TACTICS_MOUSE_MOCK
        GTEST_SKIP()
            << "libumockdev-dev is missing, or this is a build with sanitizers, which bear no other library before theirs";
#else
        if (!has_tool("umockdev-wrapper")) GTEST_SKIP() << "umockdev-wrapper is missing (package umockdev)";
#endif
        setenv("XDG_STATE_HOME", folder.path().c_str(), 1);  // what is learned of a mouse stays here
        // Hills of 8 mm along x, the same for all y; 80 mm wide.
        write_bytes(folder / "map.tif", grey_picture(160, 80, [](int x, int) { return 128 + 100 * std::sin(0.15 * x); }));
    }

    Ending run(const std::string& mock, const Words& more) {
        Words words{TACTICS_PROGRAM, "play",   "map.tif", "-q",    "--pitch",   "0.5mm",   "--low",
                    "0mm",           "--high", "10mm",    "--csv", "ticks.csv", "--device"};
#ifdef TACTICS_MOUSE_MOCK
        words.insert(words.begin(), {"umockdev-wrapper", TACTICS_MOUSE_MOCK, "got" + mock});
#else
        (void)mock;
#endif
        words.insert(words.end(), more.begin(), more.end());
        return run_tool(folder, words);
    }

    // And what holds of every play.
    Played play(const std::string& mock, const Words& more) {
        Played played{run(mock, more), {}, {}, {}};
        EXPECT_EQ(played.ending.code, 0) << played.ending.err;
        std::istringstream got(bytes_of(folder / "got")), csv(bytes_of(folder / "ticks.csv"));
        bool is_back = false;
        for (std::string line; std::getline(got, line);) {
            if (line == "back") {
                is_back = true;
                continue;
            }
            Written one;
            std::istringstream words(line);
            std::string hex;
            words >> one.good >> one.given >> hex;
            std::vector<unsigned char> bytes;
            for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
                bytes.push_back(static_cast<unsigned char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
            EXPECT_TRUE(!bytes.empty() && bytes[0] == 0);
            const auto word = bytes.empty() ? std::nullopt : force_word(std::span(bytes).subspan(1));
            EXPECT_TRUE(word) << hex;
            one.word = word.value_or(ForceWord{});
            EXPECT_LE(std::abs(one.word.force), 8);
            EXPECT_EQ(one.word.hold, 3);
            (is_back ? played.after : played.before).push_back(one);
        }
        std::string line;
        std::getline(csv, line);
        EXPECT_EQ(line, "time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n");
        while (std::getline(csv, line)) {
            std::vector<double> tick;
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, ',');) {
                EXPECT_TRUE(parse_number(cell)) << line;
                tick.push_back(parse_number(cell).value_or(0));
            }
            EXPECT_EQ(tick.size(), 7u) << line;
            tick.resize(7);
            played.ticks.push_back(tick);
        }
        EXPECT_FALSE(played.ticks.empty());
        // 8 N in 2 ms, by the program's own time: no other knows how late a tick was.
        for (std::size_t i = 1; i < played.ticks.size(); ++i) {
            const double dt = std::min(played.ticks[i][kTime] - played.ticks[i - 1][kTime], 0.005);
            EXPECT_LE(std::abs(played.ticks[i][kForce] - played.ticks[i - 1][kForce]), 4000 * dt + 0.01) << i;
        }
        return played;
    }

    // Each tick was written as it was logged, and then the motor was switched off.
    static void expect_all_was_written(const Played& played) {
        const std::vector<Written>& all = played.before;
        ASSERT_EQ(all.size(), played.ticks.size() + 1);
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            ASSERT_NEAR(all[i].word.force, played.ticks[i][kForce], 0.00051) << i;
            ASSERT_TRUE(all[i].word.motor_on);
            ASSERT_EQ(all[i].word.number, static_cast<int>(i % 256));
        }
        EXPECT_FALSE(all.back().word.motor_on);
        EXPECT_EQ(all.back().word.force, 0);
    }

    // From the sixth report without a good word on there is no force, up to the word `until`.
    static void expect_silence(const Played& played, long last_good, long until = 1L << 40) {
        int without = 0;
        double most = 0;
        for (const Written& one : played.before) {
            if (one.good < last_good) most = std::max(most, one.word.force);
            if (one.good != last_good || one.given > until) continue;
            // The first is what the last good word led to.
            if (++without > 6) {
                ASSERT_EQ(one.word.force, 0) << without;
            }
        }
        EXPECT_GT(most, 0);
        EXPECT_GT(without, 50);
    }

    static double most_force(const std::vector<Written>& all, std::size_t from, std::size_t to) {
        double most = 0;
        for (std::size_t i = from; i < std::min(to, all.size()); ++i) most = std::max(most, std::abs(all[i].word.force));
        return most;
    }

    // From that tick on, or the one before, the force is begun: 8 N in 0.3 s at most.
    static void expect_soft(const Played& played, std::size_t from) {
        double most = 0;
        ASSERT_GT(from, 1u);
        ASSERT_LT(from, played.ticks.size());
        // A tick counts for 5 ms at most, however long the mouse was away before it.
        const double begin = std::max(played.ticks[from - 2][kTime], played.ticks[from][kTime] - 0.01);
        for (std::size_t i = from; i < played.ticks.size(); ++i) {
            ASSERT_LE(std::abs(played.ticks[i][kForce]), 8 * (played.ticks[i][kTime] - begin) / 0.3 + 0.01) << i - from;
            most = std::max(most, std::abs(played.ticks[i][kForce]));
        }
        EXPECT_GT(most, 0);
    }

    Folder folder;
};

TEST_F(PlayMouse, LiftsTheFingerOverTheHills) {
    const Played played = play(",interrupt=1500", {"hid:"});
    expect_all_was_written(played);
    EXPECT_EQ(played.ending.err, "");
    // Its load is 1 N and the lever, and a newton is a millimetre. On a busy machine ticks come late, and then it begins softly
    // again.
    double soft = 0;
    for (std::size_t i = 1; i < played.ticks.size(); ++i) {
        const auto& tick = played.ticks[i];
        if (tick[kTime] - played.ticks[i - 1][kTime] > 0.005) soft = tick[kTime];
        if (tick[kTime] > soft + 0.6) {
            ASSERT_LT(std::abs(tick[kSurface] - tick[kFinger]), 2.5) << tick[kTime];
        }
    }
}

TEST_F(PlayMouse, WhatIsNoWordIsSilence) {
    for (const char* what : {"silent", "short", "magic", "sum", "random"}) {
        SCOPED_TRACE(what);
        const Played played = play("," + std::string(what) + "=400,interrupt=600", {"hid:/dev/hidraw0"});
        expect_all_was_written(played);
        expect_silence(played, 400);
    }
}

TEST_F(PlayMouse, AfterSilenceAndFaultTheForceBeginsSoftly) {
    for (const char* what : {"silent", "fault"}) {
        SCOPED_TRACE(what);
        const Played played = play("," + std::string(what) + "=400,until=480,interrupt=900", {"hid:"});
        expect_all_was_written(played);
        std::size_t from = 0;
        while (from < played.before.size() && played.before[from].given <= 480) ++from;
        if (std::string_view(what) == "silent")
            expect_silence(played, 400, 480);
        else
            EXPECT_EQ(most_force(played.before, 410, from), 0);
        expect_soft(played, from);
    }
}

TEST_F(PlayMouse, StopKeyAndCtrlCEndIt) {
    for (const char* what : {"stop", "interrupt"}) {
        SCOPED_TRACE(what);
        const Played played = play("," + std::string(what) + "=400", {"hid:"});
        expect_all_was_written(played);
        EXPECT_GT(played.before.size(), 395u);
        EXPECT_LT(played.before.size(), 460u);
        EXPECT_EQ(played.ending.err, "");
    }
}

TEST_F(PlayMouse, UnpluggedForGoodIsToldAndCtrlCEndsIt) {
    const Played played = play(",gone=400", {"hid:"});
    EXPECT_EQ(played.ending.err, "hid: it is gone; plug it in again, or end with Ctrl-C\n");
    // All ticks up to then are kept.
    ASSERT_GE(played.ticks.size(), played.before.size());
    EXPECT_LE(played.ticks.size(), played.before.size() + 1);
    for (std::size_t i = 0; i < played.before.size(); ++i)
        ASSERT_NEAR(played.before[i].word.force, played.ticks[i][kForce], 0.00051) << i;
    EXPECT_GT(most_force(played.before, 0, 1000), 0);
}

TEST_F(PlayMouse, UnpluggedAndBackUnderAnotherNumberItPlaysOnSoftly) {
    const Played played = play(",gone=400,back=300,interrupt=1000", {"hid:"});
    EXPECT_EQ(played.ending.err, "hid: it is gone; plug it in again, or end with Ctrl-C\nhid: there again\n");
    ASSERT_GT(played.after.size(), 400u);
    const std::size_t from = played.ticks.size() + 1 - played.after.size();
    expect_soft(played, from);
    EXPECT_FALSE(played.after.back().word.motor_on);
    EXPECT_EQ(played.after.back().word.force, 0);
    // The time that it was away is in the log.
    EXPECT_GT(played.ticks[from][kTime] - played.ticks[from - 1][kTime], 0.25);
}

TEST_F(PlayMouse, OneThatIsNamedIsNotLookedForElsewhere) {
    // It is over when its seconds are, mouse or none.
    const Played played = play(",gone=200,back=200", {"hid:/dev/hidraw0", "--seconds", "1"});
    EXPECT_EQ(played.ending.err, "hid:/dev/hidraw0: it is gone; plug it in again, or end with Ctrl-C\n");
    EXPECT_TRUE(played.after.empty());
}

TEST_F(PlayMouse, OneThatNeverSaysAWordIsToldNothing) {
    const Ending ending = run(",mute", {"hid:"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.err, "hid: it says nothing, its force is off; unplug it and plug it in again, or end with Ctrl-C\n");
    EXPECT_EQ(bytes_of(folder / "got"), "");
}

TEST_F(PlayMouse, OfSeveralOneIsNamed) {
    const Ending any = run(",second", {"hid:"});
    EXPECT_EQ(any.code, 2);
    EXPECT_TRUE(holds(any.err, "hid: several haptic mice are there: hid:/dev/hidraw0, hid:/dev/hidraw1; name one of them"))
        << any.err;
    const Played played = play(",second,interrupt=100", {"hid:/dev/hidraw0"});
    expect_all_was_written(played);
}

TEST_F(PlayMouse, AKeyboardIsNoMouse) {
    const Ending none = run(",keyboard", {"hid:"});
    EXPECT_EQ(none.code, 2);
    EXPECT_TRUE(holds(none.err, "hid: there is no haptic mouse; plug it in")) << none.err;
    const Ending other = run(",keyboard", {"hid:/dev/hidraw0"});
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(holds(other.err, "/dev/hidraw0: it is no haptic mouse")) << other.err;
    const Ending missing = run("", {"hid:/dev/hidraw7"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_TRUE(holds(missing.err, "/dev/hidraw7: it is not there")) << missing.err;
    EXPECT_EQ(bytes_of(folder / "got"), "");
}

}  // namespace
}  // namespace tactics::play_mouse_test
