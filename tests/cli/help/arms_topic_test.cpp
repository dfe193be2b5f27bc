// SPDX-License-Identifier: Apache-2.0
// `tactics help arms` against what the program has.
#include <gtest/gtest.h>

#include <sstream>

#include "cli/help/describe.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/voice/plot_keys.h"

namespace tactics::arms_topic_test {
namespace {

TEST(ArmsTopic, TellsOfEachArmHowItIsNamed) {
    const std::string text = describe_topic("arms");
    int arms = 0;
    for (const DeviceKind* kind : device_kinds()) {
        if (kind->axes == 1) continue;
        ++arms;
        const std::string begin = "\n" + std::string(kind->name);
        EXPECT_TRUE(text.find(begin + ":") != std::string::npos || text.find(begin + " is") != std::string::npos) << kind->name;
        EXPECT_FALSE(kind->finds_place) << kind->name;
        EXPECT_EQ(kind->address.empty(), kind->has_hand) << kind->name;  // what is simulated is nowhere
    }
    EXPECT_GE(arms, 4);
}

TEST(ArmsTopic, TellsOfEachKey) {
    const std::string text = describe_topic("arms");
    for (std::size_t i = 0; i < plot_keys().size(); ++i) {
        const PlotKey& key = plot_keys()[i];
        std::string how = i < kNumberedKeys ? std::to_string(i + 1) : "";
        if (key.letter != 0) how += (how.empty() ? "" : " or ") + std::string(1, key.letter);
        EXPECT_NE(text.find("\n  " + how + ": " + std::string(key.name.text) + ", "), std::string::npos) << key.name.text;
    }
}

TEST(ArmsTopic, ItsLinesAreShort) {
    std::istringstream lines(describe_topic("arms"));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

}  // namespace
}  // namespace tactics::arms_topic_test
