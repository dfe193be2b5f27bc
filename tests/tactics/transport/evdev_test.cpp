// SPDX-License-Identifier: Apache-2.0
// A touch overlay that umockdev pretends: what is read of it, and the real program with a mouse and an overlay.
#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/transport/touch_device.h"
#include "tactics/units.h"
#include "tests/cli/schemas.h"
#include "tests/cli/tool.h"

namespace tactics::tests::evdev_test {
namespace {

TEST(Evdev, SaysWhyItCannotBeOpened) {
    const Folder folder;
    const auto message = [](const std::string& path) -> std::string {
        try {
            open_touch_device(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    const std::string missing = (folder / "event0").string(), file = (folder / "file").string();
    EXPECT_EQ(message(missing), missing +
                                    ": there is no such device; plug it in, or find its name in /proc/bus/input/devices (event "
                                    "and a number, below /dev/input)");
    write_bytes(file, "no device");
    EXPECT_EQ(
        message(file),
        file +
            ": is no input device; an overlay is one of /dev/input/event0, event1 ...; find its name in /proc/bus/input/devices");
    EXPECT_TRUE(message("/dev/null").starts_with("/dev/null: is no input device"));
    if (geteuid() == 0) return;  // to whom nothing is forbidden
    std::filesystem::permissions(file, std::filesystem::perms::none);
    EXPECT_EQ(message(file), file + ": you are not permitted to use it; sudo setfacl -m u:$USER:r " + file +
                                 " permits it until it is unplugged");
}

class OverlayMock : public testing::Test {
protected:
    void SetUp() override {
#ifndef TACTICS_OVERLAY_MOCK
        GTEST_SKIP()
            << "libumockdev-dev is missing, or this is a build with sanitizers, which bear no other library before theirs";
#else
        if (!has_tool("umockdev-wrapper")) GTEST_SKIP() << "umockdev-wrapper is missing (package umockdev)";
#endif
        setenv("XDG_STATE_HOME", folder.path().c_str(), 1);  // what is learned of a mouse stays here
        // 100 x 60 mm, and even.
        write_bytes(folder / "map.pgm", "P5 100 60 255\n" + std::string(100 * 60, 'm'));
    }
    Ending run(const std::string& kind, Words words) {
#ifdef TACTICS_OVERLAY_MOCK
        if (words.empty()) words = {TACTICS_TOUCH_EXCHANGE, "/dev/input/event0"};
        words.insert(words.begin(), {"umockdev-wrapper", TACTICS_OVERLAY_MOCK, kind});
#else
        (void)kind;
#endif
        return run_tool(folder, words);
    }
    Ending play(const std::string& kind, const Words& more) {
        Words words{TACTICS_PROGRAM, "play", "map.pgm",  "--pitch",          "1mm",   "--low",    "0mm",
                    "--high",        "5mm",  "--device", "hid:/dev/hidraw0", "--csv", "ticks.csv"};
        words.insert(words.end(), more.begin(), more.end());
        return run(kind, words);
    }
    // Column by column, of the first tick or the last.
    std::vector<double> tick(bool last) {
        std::vector<std::string> lines{""};
        for (const char c : bytes_of(folder / "ticks.csv")) {
            if (c == '\n')
                lines.emplace_back();
            else
                lines.back() += c;
        }
        if (lines.size() < 3) return std::vector<double>(7);
        const std::string line = lines[last ? lines.size() - 2 : 1] + ",";
        std::vector<double> numbers;
        for (std::size_t at = 0; at < line.size(); at = line.find(',', at) + 1)
            numbers.push_back(parse_number(line.substr(at, line.find(',', at) - at)).value_or(-1e9));
        return numbers;
    }
    Folder folder;
};

TEST_F(OverlayMock, TellsContactsBySlots) {
    const Ending ending = run("slots", {});
    EXPECT_EQ(ending.code, 0) << ending.err;
    // What is down when it is opened is told at once. At 12.6 the kernel has dropped that one contact went and the other moved.
    EXPECT_EQ(ending.out,
              "0 to 6000, 10 a mm\n0 to 6000, 10 a mm\nnow: 1000,2000\n12.500: 1010,2000\n12.516: 1010,2000 3000,4000\n12.600: "
              "3000,4000\n12.600: 3500,4000\n"
              "12.700: 3500,4020\ngone\n");
}

TEST_F(OverlayMock, BelongsToWhoOpenedItUntilItIsClosed) {
    const Ending ending = run("slots", {});
    EXPECT_EQ(ending.err, "the overlay is grabbed\nthe overlay is let go\n");
    // Without exclusive use the program goes on, and does not release what it did not grab.
    const Ending taken = run("taken", {});
    EXPECT_EQ(taken.code, 0);
    EXPECT_EQ(taken.out, ending.out);
    EXPECT_EQ(taken.err, "the overlay is grabbed\n");
    EXPECT_EQ(run("joystick", {}).err, "");
}

TEST_F(OverlayMock, IsListedBesideTheMouse) {
    const Ending ending = run("slots", {TACTICS_PROGRAM, "devices"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.out,
                      "hid:/dev/hidraw0: Pretended mouse; haptic mouse: play --device hid:/dev/hidraw0\n"
                      "/dev/input/event0: Pretended frame; touch overlay or touch screen: play --overlay /dev/input/event0\n"))
        << ending.out;
    EXPECT_EQ(ending.err, "");
    const Ending json = run("slots", {TACTICS_PROGRAM, "devices", "--json"});
    EXPECT_TRUE(holds(
        json.out,
        R"({"schema":1,"address":"/dev/input/event0","id":"Pretended frame","embosser":"","note":"touch overlay or touch screen: play --overlay /dev/input/event0"})"))
        << json.out;
    if (has_json_schema()) {
        EXPECT_EQ(schema_faults("devices", json.out), "");
    }
}

TEST_F(OverlayMock, TellsOneContactByATouch) {
    const Ending ending = run("single", {});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(ending.out, "0 to 6000, 0 a mm\n0 to 6000, 0 a mm\n12.500: 100,200\n12.516: 110,200\n12.600:\ngone\n");
}

TEST_F(OverlayMock, WhatIsNoOverlayIsRefused) {
    EXPECT_EQ(run("joystick", {}).out,
              "/dev/input/event0: is no touch device but \"Pretended frame\"; name one that tells where it is touched; find it "
              "in /proc/bus/input/devices\n");
    EXPECT_TRUE(holds(run("flat", {}).out, "/dev/input/event0: its axes have no range"));
    const Ending ending = play("single", {"--overlay", "/dev/input/event0"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "/dev/input/event0: the overlay does not tell how large it is")) << ending.err;
}

// The hand rests at (60, 50) mm of the overlay, and goes 50 mm to the right. The mouse counts a fifth less than it should.
TEST_F(OverlayMock, TheFingerIsWhereTheOverlaySaysItIs) {
    write_bytes(folder / "mouse.txt", "sensors.counts = 40 1/mm\n");
    const Ending ending = play("play", {"--overlay", "auto", "--map-at", "50,30mm", "--lever", "mouse.txt"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const auto begin = tick(false), end = tick(true);
    EXPECT_NEAR(begin[1], 10, 0.5);
    EXPECT_NEAR(begin[2], 20, 0.5);
    // By the mouse alone, whose counts are assumed too small, it would be at 49; a busy machine gets few samples of the overlay.
    EXPECT_NEAR(end[1], 60, 4);
    EXPECT_NEAR(end[2], 20, 4);
    EXPECT_FALSE(holds(ending.err, "middle of the map")) << ending.err;
    // What the lever bears is told before.
    EXPECT_TRUE(holds(ending.err, "\nthe overlay is grabbed\n") && holds(ending.err, "\nthe overlay is let go\n")) << ending.err;
}

TEST_F(OverlayMock, WithoutItTheMouseGoesOnAlone) {
    const Ending ending = play("leaving", {"--overlay", "/dev/input/event0", "--map-at", "50mm,30mm"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const auto count = [&](const std::string& word) {
        std::size_t found = 0;
        for (auto at = ending.err.find(word); at != std::string::npos; at = ending.err.find(word, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("the touch overlay is gone"), 1u) << ending.err;
    EXPECT_EQ(count("the touch overlay is there again"), 1u) << ending.err;
    EXPECT_EQ(count("the overlay is grabbed"), 2u) << ending.err;
    EXPECT_NEAR(tick(true)[1], 60, 1);
    EXPECT_NEAR(tick(true)[2], 20, 1);
}

TEST_F(OverlayMock, WithoutAnyTheFingerBeginsInTheMiddle) {
    const Ending ending = play("play", {});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(
        holds(ending.err, "hid:/dev/hidraw0: the finger begins in the middle of the map, as no overlay tells where it is"))
        << ending.err;
    EXPECT_NEAR(tick(true)[1], 100, 1);
    EXPECT_NEAR(tick(true)[2], 30, 1);
}

TEST(OverlayFlags, SayWhatIsWrong) {
    const Folder folder;
    const auto message = [&](Words words) {
        words.insert(words.begin(), {"play", "map.pgm"});
        const Ending ending = run_tactics(folder, words);
        EXPECT_NE(ending.code, 0);
        return ending.err;
    };
    EXPECT_TRUE(holds(message({"--overlay-size", "600x340mm"}),
                      "--overlay-size: it is about a touch overlay; name that, too: --overlay auto"));
    EXPECT_TRUE(holds(message({"--map-at", "1,1"}), "--map-at: it is about a touch overlay"));
    EXPECT_TRUE(holds(message({"--overlay", "auto"}), "--overlay: it goes with a real mouse (--device hid:)"));
    for (const char* size : {"600mm", "600x", "x340mm", "0x340mm", "600x-1mm", "600x20000mm", "600kgx340mm"})
        EXPECT_TRUE(holds(message({"--device", "hid:", "--overlay", "auto", "--overlay-size", size}),
                          "--overlay-size: it is a width and a height from 10mm to 10m, such as 600x340mm"))
            << size;
    for (const char* at : {"50mm", "a,b", "50mm,", "20m,1"})
        EXPECT_TRUE(holds(message({"--device", "hid:", "--overlay", "auto", "--map-at", at}),
                          "--map-at: it is how far to the right and how far down the map begins, such as 50mm,30mm"))
            << at;
    EXPECT_TRUE(holds(message({"--device", "hid:", "--overlay", "auto", "--overlay-size", "60x34cm", "--map-at", "-5mm,3cm"}),
                      "map.pgm"));  // which is not there
}

}  // namespace
}  // namespace tactics::tests::evdev_test
