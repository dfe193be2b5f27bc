// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/lever_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tactics/error.h"

namespace tactics::lever_file_test {
namespace {

TEST(LeverFile, ReadsWhatItWrites) {
    MouseSettings mouse{kLevers[1].lever, kFingers[2].finger, {52, 15.7, -3, 64}, true};
    mouse.lever.delay = 0.0015;
    mouse.lever.encoder_step = 0.0146;
    mouse.finger.preload = 0.75;
    EXPECT_EQ(read_mouse(to_text(mouse), "mouse.txt"), mouse);
    EXPECT_EQ(read_mouse("", "mouse.txt"), MouseSettings{});
}

TEST(LeverFile, PresetsComeFirst) {
    const MouseSettings mouse =
        read_mouse("# another hand\nlever = heavy\nfinger = soft\r\nfinger.mass = 6 g  # weighed\n", "mouse.txt");
    EXPECT_EQ(mouse.lever, kLevers[1].lever);
    EXPECT_EQ(mouse.finger.mass_g, 6);
    EXPECT_EQ(mouse.finger.stiffness, kFingers[0].finger.stiffness);
}

TEST(LeverFile, SaysWhatIsWrongAndWhere) {
    const auto message = [](const char* text) -> std::string {
        try {
            read_mouse(text, "mouse.txt");
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::usage);
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("\nlever.mas = 30 g\n"), "mouse.txt:2: a mouse has no \"lever.mas\" (lever.mass?)");
    EXPECT_EQ(message("lever.mass = 30\n"), "mouse.txt:1: lever.mass has no unit that fits (give 1 to 5000 g)");
    EXPECT_EQ(message("lever.mass = 30 kg\n"), "mouse.txt:1: lever.mass has no unit that fits (give 1 to 5000 g)");
    EXPECT_EQ(message("lever.mass = much g\n"), "mouse.txt:1: lever.mass is no number (give 1 to 5000 g)");
    EXPECT_EQ(message("lever.mass = 0 g\n"), "mouse.txt:1: lever.mass is out of range (give 1 to 5000 g)");
    EXPECT_EQ(message("sensors.apart = 1 mm\n"), "mouse.txt:1: sensors.apart is out of range (give 5 to 500 mm)");
    EXPECT_EQ(message("lever.mass 30 g\n"), "mouse.txt:1: no \"=\" (write NAME = VALUE UNIT)");
    EXPECT_EQ(message("finger = sof\n"), "mouse.txt:1: no finger is called \"sof\" (soft?)");
    EXPECT_EQ(message("lever.mass = 3 g\nlever.mass = 4 g\n"), "mouse.txt:2: lever.mass is given twice (take one of them out)");
    EXPECT_EQ(message("lever.mass = 3 g\nlever = heavy\n"), "mouse.txt:2: lever would undo lever.mass above it (put it first)");
    EXPECT_EQ(message("lever.lowest = 70 mm\n"),
              "mouse.txt: lever.lowest is not below lever.highest (leave the lever a way between its stops)");
    EXPECT_NE(message(std::string(100'000, '#').c_str()), "");
}

}  // namespace
}  // namespace tactics::lever_file_test
