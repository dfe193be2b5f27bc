// SPDX-License-Identifier: Apache-2.0
// What an Inverse Service says, and what it is told.
#include "tactics/haptics/devices/inverse3_messages.h"

#include <gtest/gtest.h>

#include <limits>

namespace tactics::inverse3_messages_test {
namespace {

// In the manner of Haply's documents: one with the members of 3.5, one with those of 3.1.
const std::string kOfNow = R"({"session_id": 7, "inverse3": [{"device_id": "049D", "state": {"cursor_position":
    {"x": 0.0125, "y": -0.12, "z": 0.15}, "cursor_velocity": {"x": 1, "y": 2, "z": 3}, "control_mode": "idle"},
    "status": {"calibrated": true, "in_use": true, "power_supply": true, "ready": true, "started": true}}],
    "wireless_verse_grip": [{"device_id": "1", "state": {"buttons": {"a": true, "b": false, "c": true}}}]})";
const std::string kOfThen = R"({"inverse3": [{"device_id": "04BA", "state": {"cursor_position": {"x": 0.07842738,
    "y": -0.14836666, "z": 0.14297646}, "mode": "idle"}, "status": {"calibrated": false, "ready": true}}],
    "verse_grip": [{"device_id": "61548", "state": {"button": true, "hall": 0}}]})";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    if (at == std::string::npos) ADD_FAILURE() << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(Inverse3Messages, PlacesAreMillimetresAndKeysAreBits) {
    const auto now = inverse3_word(kOfNow, "049D");
    ASSERT_TRUE(now);
    EXPECT_NEAR(now->place.x, 12.5, 1e-9);
    EXPECT_NEAR(now->place.y, 150, 1e-9);  // up
    EXPECT_NEAR(now->place.z, 120, 1e-9);  // towards the person
    EXPECT_EQ(now->keys, 5u);
    EXPECT_FALSE(now->fault);
    const auto then = inverse3_word(kOfThen, "04BA");
    ASSERT_TRUE(then);
    EXPECT_NEAR(then->place.z, 148.36666, 1e-9);
    EXPECT_EQ(then->keys, 1u);
    EXPECT_TRUE(then->fault);  // not calibrated
    const auto own = inverse3_word(replaced(kOfNow, R"("a": true, "b": false, "c": true)", R"("button_3": true)"), "049D");
    ASSERT_TRUE(own);
    EXPECT_EQ(own->keys, 8u);
}

TEST(Inverse3Messages, WhatIsNotReadyIsAtFault) {
    for (const char* what : {R"("ready": true)", R"("calibrated": true)", R"("power_supply": true)"}) {
        const auto word = inverse3_word(replaced(kOfNow, what, replaced(what, "true", "false")), "049D");
        ASSERT_TRUE(word) << what;
        EXPECT_TRUE(word->fault) << what;
        // One that is not told is taken to be well.
        const auto untold = inverse3_word(replaced(kOfNow, what, R"("other": 1)"), "049D");
        ASSERT_TRUE(untold) << what;
        EXPECT_FALSE(untold->fault) << what;
    }
}

TEST(Inverse3Messages, NonsenseIsNothing) {
    const std::string bad[] = {"",
                               "null",
                               "[]",
                               "{}",
                               R"({"inverse3": 5})",
                               R"({"inverse3": [5, null]})",
                               kOfNow.substr(0, kOfNow.size() / 2),
                               kOfNow + "x",
                               replaced(kOfNow, "0.0125", "NaN"),
                               replaced(kOfNow, "0.0125", "1e999"),
                               replaced(kOfNow, "0.0125", "1e300"),
                               replaced(kOfNow, "0.0125", "1.001"),
                               replaced(kOfNow, "0.0125", "\"0.0125\""),
                               replaced(kOfNow, "\"z\": 0.15", "\"w\": 0.15"),
                               replaced(kOfNow, "cursor_position", "cursor_place"),
                               replaced(kOfNow, "049D", "049E"),
                               replaced(kOfNow, "049D", "\xFF"),
                               kOfNow + std::string(kMostInverseMessage, ' '),
                               std::string(100'000, '['),
                               R"({"a":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}"};
    for (const std::string& text : bad) EXPECT_FALSE(inverse3_word(text, "049D")) << text.substr(0, 60);
}

TEST(Inverse3Messages, DevicesAreNamedByWhatCanBeAnId) {
    EXPECT_EQ(inverse3_ids(kOfNow), std::vector<std::string>{"049D"});
    EXPECT_EQ(inverse3_ids("{}"), std::vector<std::string>{});
    EXPECT_EQ(inverse3_ids(R"({"inverse3": []})"), std::vector<std::string>{});
    EXPECT_EQ(
        inverse3_ids(R"({"inverse3": [{"device_id": "a\"b"}, {"device_id": ""}, {"device_id": 7}, {}, {"device_id": "04BA"}]})"),
        std::vector<std::string>{"04BA"});
    EXPECT_FALSE(inverse3_ids("hello"));
    EXPECT_FALSE(inverse3_ids("[1]"));
}

// As Haply's documents have it, letter by letter.
TEST(Inverse3Messages, AForceIsACommandToOneDevice) {
    EXPECT_EQ(inverse3_request("049D", {0.5, 2.25, 1}, false),
              R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"values":{"x":0.5,"y":-1,"z":2.25}}}}]})");
    EXPECT_EQ(inverse3_request("049D", {}, true),
              R"({"session":{"configure":{"profile":{"name":"tactics"}}},"inverse3":[{"device_id":"049D",)"
              R"("configure":{"preset":{"preset":"arm_front_centered"}},)"
              R"("commands":{"set_cursor_force":{"values":{"x":0,"y":0,"z":0}}}}]})");
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(inverse3_request("a", {none, -std::numeric_limits<double>::infinity(), -1}, false),
              R"({"inverse3":[{"device_id":"a","commands":{"set_cursor_force":{"values":{"x":0,"y":1,"z":0}}}}]})");
}

}  // namespace
}  // namespace tactics::inverse3_messages_test
