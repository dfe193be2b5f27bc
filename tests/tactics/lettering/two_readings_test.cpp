// SPDX-License-Identifier: Apache-2.0
// What two readings of a noisy picture say together.
#include "tactics/lettering/two_readings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tactics::two_readings_test {
namespace {

struct Said {
    std::string text;
    bool sure;
    int left, top, width = 60;
};

Lettering reading(const std::vector<Said>& said) {
    Lettering lettering;
    lettering.width = 400, lettering.height = 300;
    lettering.found_any = !said.empty();
    for (const Said& one : said) {
        PrintedWords words;
        words.text = one.text;
        words.sure = one.sure;
        words.box = {one.left, one.top, one.left + one.width, one.top + 16};
        lettering.words.push_back(words);
    }
    return lettering;
}

// What stands, and in brackets what is told; with a star what is out of the lines.
std::string together(const std::vector<Said>& given, const std::vector<Said>& smoothed) {
    std::string said;
    for (const PrintedWords& one : put_together(reading(given), reading(smoothed)).words) {
        said += said.empty() ? "" : " ";
        said += one.sure ? one.text : "(" + one.text + ")" + (one.out ? "*" : "");
    }
    return said;
}

TEST(TwoReadings, OneThatIsSureDoesIfTheOtherReadsTheSame) {
    EXPECT_EQ(together({{"Oak", true, 20, 20}}, {{"Oak", false, 21, 19}}), "Oak");
    EXPECT_EQ(together({{"Oak", false, 20, 20}}, {{"Oak", true, 21, 19}}), "Oak");
    EXPECT_EQ(together({{"Oak", false, 20, 20}}, {{"Oak", false, 21, 19}}), "(Oak)");
    EXPECT_EQ(together({{"Oak", true, 20, 20}}, {{"", false, 21, 19}}), "Oak") << "which was not read at all";
}

TEST(TwoReadings, LettersThatBothReadWithHighSurenessAreSure) {
    const auto is_sure = [](const std::string& text, double given, double smoothed) {
        Lettering a = reading({{text, false, 20, 20}}), b = reading({{text, false, 20, 20}});
        a.words[0].sureness = given, b.words[0].sureness = smoothed;
        return put_together(a, b).words[0].sure;
    };
    EXPECT_TRUE(is_sure("Oak", 96, 95));
    EXPECT_FALSE(is_sure("Oak", 96, 90));
    EXPECT_FALSE(is_sure("100", 97, 97)) << "no word bears out a figure";
    EXPECT_FALSE(is_sure("in", 97, 97)) << "two marks are read as two letters";
}

TEST(TwoReadings, NothingIsSureWhereTheyDiffer) {
    EXPECT_EQ(together({{"10", true, 20, 20}}, {{"19", false, 20, 20}}), "(10)*");
    EXPECT_EQ(together({{"cos x", false, 20, 20}}, {{"COS X", true, 20, 20}}), "(cos x)");
    EXPECT_EQ(together({{"10", true, 20, 20}}, {{"1", false, 20, 20}}), "(10)*") << "a part of a number is another one";
    EXPECT_EQ(together({{"2.0", true, 20, 20}}, {{"20", true, 20, 20}}), "(2.0)*");
}

TEST(TwoReadings, AWholeLabelIsBorneOutByItsParts) {
    EXPECT_EQ(together({{"R", true, 20, 20, 16}, {"10 km", false, 60, 20}}, {{"R = 10 km", true, 20, 20, 100}}), "R = 10 km");
    EXPECT_EQ(together({{"Order of", true, 20, 20}}, {{"Order of ...", false, 20, 20, 90}}), "(Order of ...)")
        << "the other one is more, so the part is not sure, and the whole is told";
}

TEST(TwoReadings, WhatOnlyOneHasFoundIsKeptButALetterByItselfIsNotSure) {
    EXPECT_EQ(together({{"Wool", true, 20, 20}}, {}), "Wool");
    EXPECT_EQ(together({}, {{"Wool", true, 20, 20}}), "Wool");
    EXPECT_EQ(together({{"1", true, 20, 20, 4}}, {}), "(1)") << "it may be noise in a line, and stays there";
    EXPECT_EQ(together({}, {{"Ω", true, 20, 20, 14}}), "(Ω)");
    EXPECT_EQ(together({{"", false, 20, 20}}, {}), "()");
}

TEST(TwoReadings, StandInTheirOrderAndPlacesBesideEachOtherAreTwo) {
    EXPECT_EQ(together({{"low", true, 20, 120}, {"right", true, 200, 20}}, {{"left", true, 20, 20}, {"low", true, 20, 120}}),
              "left right low");
    EXPECT_EQ(together({{"near", true, 20, 20}}, {{"next", true, 75, 20}}), "near next") << "5 pixels of 60 are of both";
    EXPECT_TRUE(put_together(reading({}), reading({{"a", true, 0, 0}})).found_any);
    EXPECT_EQ(put_together(reading({}), reading({})).width, 400);
}

}  // namespace
}  // namespace tactics::two_readings_test
