// SPDX-License-Identifier: Apache-2.0
// Numbers of an axis against what their places say.
#include <gtest/gtest.h>

#include <string>

#include "tactics/lettering/read_line.h"

namespace tactics::axis_numbers_test {
namespace {

// A number of 8 pixels, right-aligned beside an upright axis or centred below a level one.
ReadLine number(double x, double y, const std::string& text, bool sure, std::vector<std::string> readings = {}) {
    ReadLine one;
    const int width = 6 * static_cast<int>(text.size());
    const int left = static_cast<int>(x) - width / 2, top = static_cast<int>(y) - 4;
    one.line.box = {left, top, left + width, top + 8};
    one.line.letter_height = 8;
    one.line.letters.resize(text.size());
    one.words.text = text;
    one.words.sure = sure;
    one.readings = readings.empty() ? std::vector<std::string>{text} : std::move(readings);
    return one;
}

// What is sure, from the left to the right; "?" is not.
std::string held(std::vector<ReadLine> lines) {
    hold_against_axes(lines);
    std::string said;
    for (const ReadLine& one : lines) said += (said.empty() ? "" : " ") + (one.words.sure ? one.words.text : "?");
    return said;
}

TEST(AxisNumbers, AReaderIsBorneOutByThePlace) {
    EXPECT_EQ(held({number(40, 90, "o", false), number(100, 90, "1", true), number(160, 90, "2", true),
                    number(220, 90, "3", true), number(280, 90, "A", false, {"A", "4"})}),
              "0 1 2 3 4");
    EXPECT_EQ(
        held({number(40, 90, "8", false), number(100, 90, "1", true), number(160, 90, "2", true), number(220, 90, "3", true)}),
        "? 1 2 3")
        << "nobody read a 0";
    EXPECT_EQ(
        held({number(58, 90, "0", false), number(100, 90, "1", true), number(160, 90, "2", true), number(220, 90, "3", true)}),
        "? 1 2 3")
        << "it stands at no step";
    EXPECT_EQ(held({number(40, 90, "0", false), number(100, 90, "1", true), number(160, 90, "2", true)}), "? 1 2") << "too few";
    EXPECT_EQ(held({number(40, 90, "O", false), number(100, 90, "5", true), number(160, 90, "lo", false),
                    number(220, 90, "I5", false), number(280, 90, "20", true), number(340, 90, "26", false)}),
              "0 5 10 15 20 ?")
        << "two, and most others say so, too";
    EXPECT_EQ(held({number(40, 90, "O", false), number(100, 90, "5", true), number(160, 90, "lo", false),
                    number(220, 90, "8", false), number(280, 90, "20", true), number(340, 90, "26", false)}),
              "? 5 ? ? 20 ?");
    EXPECT_EQ(held({number(40, 90, "0", true), number(160, 90, "t0", false, {"t0", "10"}),
                    number(220, 90, "t5", false, {"15", "t5"}), number(280, 90, "20", true)}),
              "0 10 15 20")
        << "four figures say so";
    EXPECT_EQ(
        held({number(40, 90, "0", true), number(100, 90, "l", false), number(160, 90, "2", false), number(280, 90, "4", true)}),
        "0 ? ? 4")
        << "two may by accident";
}

TEST(AxisNumbers, ASpaceIsNoneOfANumber) {
    EXPECT_EQ(held({number(40, 90, "\u22121 .0", false), number(100, 90, "\u22120.5", true), number(160, 90, "0.0", true),
                    number(220, 90, "0.5", true)}),
              "\u22121.0 \u22120.5 0.0 0.5");
}

TEST(AxisNumbers, SignsAreThoseOfTheOthers) {
    EXPECT_EQ(held({number(40, 90, "1,000", true), number(100, 90, "2,000", true), number(160, 90, "3.000", false),
                    number(220, 90, "4,000", true)}),
              "1,000 2,000 3,000 4,000");
    EXPECT_EQ(held({number(40, 90, "0,5", true), number(100, 90, "1,0", true), number(160, 90, "1,5", true),
                    number(220, 90, "2.0", false)}),
              "0,5 1,0 1,5 2,0");
    EXPECT_EQ(held({number(40, 90, "~20", false), number(100, 90, "\u221210", true), number(160, 90, "0", true),
                    number(220, 90, "10", true)}),
              "\u221220 \u221210 0 10");
}

TEST(AxisNumbers, GrowByFactorsToo) {
    EXPECT_EQ(held({number(40, 90, "1", true), number(100, 90, "10", true), number(160, 90, "1OO", false),
                    number(220, 90, "1000", true)}),
              "1 10 100 1000");
    EXPECT_EQ(held({number(40, 90, "1", true), number(100, 90, "10", true), number(160, 90, "80", false),
                    number(220, 90, "1000", true)}),
              "1 10 ? 1000");
}

TEST(AxisNumbers, WhatThePlaceDeniesIsNotSureInSmallPrint) {
    EXPECT_EQ(held({number(40, 90, "0.8", true), number(100, 90, "10", true), number(160, 90, "1.2", true),
                    number(220, 90, "1.4", true), number(280, 90, "1.6", true)}),
              "0.8 ? 1.2 1.4 1.6")
        << "1.0";
    std::vector<ReadLine> large{number(40, 90, "1", true), number(100, 90, "2", true), number(160, 90, "3", true),
                                number(220, 90, "4", true), number(280, 90, "10", true)};
    for (ReadLine& one : large) one.line.letter_height = 20, one.line.box.bottom += 12;
    EXPECT_EQ(held(large), "1 2 3 4 10") << "names of classes";
    std::vector<ReadLine> years{number(40, 90, "1990", true), number(100, 90, "1995", true), number(160, 90, "2000", true),
                                number(220, 90, "2008", true), number(280, 90, "2010", true)};
    for (ReadLine& one : years) one.line.letter_height = 10, one.line.box.bottom += 2;
    EXPECT_EQ(held(years), "1990 1995 2000 2008 2010") << "large enough to be read";
    EXPECT_EQ(
        held({number(40, 90, "1", true), number(100, 90, "4", true), number(160, 90, "9", true), number(220, 90, "16", true)}),
        "1 4 9 16");
}

// One reader is enough where three numbers say the same of their axis.
TEST(AxisNumbers, BearEachOtherOutThoughNoneIsSure) {
    const auto borne_out = [](const std::vector<std::string>& texts) {
        std::vector<ReadLine> lines;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            lines.push_back(number(50, 240 - 50.0 * static_cast<double>(i), texts[i], false));
            ReadLine& one = lines.back();
            one.line.upwards = one.nearly = one.tell = true;
            const int across = one.line.box.height(), along = one.line.box.width();
            one.line.box.right = one.line.box.left + across;
            one.line.box.top -= along / 2 - across / 2;
            one.line.box.bottom = one.line.box.top + along;
            one.line.box.left = 46, one.line.box.right = 54;
        }
        return held(lines);
    };
    EXPECT_EQ(borne_out({"10", "20", "30", "40"}), "10 20 30 40");
    EXPECT_EQ(borne_out({"10", "20", "80", "40"}), "10 20 ? 40");
    EXPECT_EQ(borne_out({"10", "20"}), "? ?");
    EXPECT_EQ(borne_out({"12", "35", "47", "58"}), "? ? ? ?");
}

// Beside an upright axis numbers end at one place.
TEST(AxisNumbers, StandAboveEachOther) {
    std::vector<ReadLine> lines;
    const char* const texts[] = {"100", "80", "60", "4O", "20", "o"};
    for (int i = 0; i < 6; ++i) {
        lines.push_back(number(50, 40.0 + 30 * i, texts[i], i != 3 && i != 5));
        PixelBox& box = lines.back().line.box;
        box = {60 - box.width(), box.top, 60, box.bottom};
    }
    EXPECT_EQ(held(lines), "100 80 60 40 20 0");
    lines[1].line.box.top += 9, lines[1].line.box.bottom += 9;  // of no step, so it is something else
    EXPECT_EQ(held(lines), "100 80 60 40 20 0");
}

// A scan is not quite level: five pixels over 450.
TEST(AxisNumbers, NeedNotBeQuiteAboveEachOther) {
    const auto column = [](int lean) {
        std::vector<ReadLine> lines;
        const char* const texts[] = {"12", "8", "4", "o"};
        for (int i = 0; i < 4; ++i) {
            lines.push_back(number(50, 40 + 150 * i, texts[i], i != 3));
            PixelBox& box = lines.back().line.box;
            const int right = 100 + lean * i / 3;
            box = {right - box.width(), box.top, right, box.bottom};
        }
        return lines;
    };
    EXPECT_EQ(held(column(5)), "12 8 4 0");
    EXPECT_EQ(held(column(12)), "12 8 4 ?");
}

// White before a minus sign moves a number aside, by less than its height.
TEST(AxisNumbers, WithAMinusSignMayStandALittleAside) {
    const auto row = [](double aside) {
        return held({number(116 - aside, 90, "-2", false), number(186 - aside, 90, "-1", false), number(256, 90, "0", true),
                     number(326, 90, "1", true), number(396, 90, "2", true)});
    };
    EXPECT_EQ(row(3), "\u22122 \u22121 0 1 2");
    EXPECT_EQ(row(5), "? ? 0 1 2");
}

// Places are whole pixels: two that stand side by side tell the step less well than two that are far apart.
TEST(AxisNumbers, TheFarthestTellTheStep) {
    EXPECT_EQ(held({number(40, 90, "0", true), number(91, 90, "1", true), number(141, 90, "2", true),
                    number(342, 90, "b", false, {"6", "b"})}),
              "0 1 2 6");
}

TEST(AxisNumbers, OfHostileLinesIsBounded) {
    std::vector<ReadLine> lines;
    for (int i = 0; i < 300; ++i) lines.push_back(number(10.0 + 9 * i, 90, std::to_string(i * i % 97), true));
    hold_against_axes(lines);
    for (const char* text : {"", ",", ".", "-", "1,", ",5", "1,2,3", "1.2.3", "00", "1e3", "\xff", "9999999999999999999999"})
        hold_against_axes(lines = {number(40, 90, text, true), number(100, 90, text, true), number(160, 90, text, true),
                                   number(220, 90, text, true)});
}

}  // namespace
}  // namespace tactics::axis_numbers_test
