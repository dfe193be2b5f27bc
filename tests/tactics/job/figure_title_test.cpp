// SPDX-License-Identifier: Apache-2.0
// Long titles of figures.
#include "tactics/job/figure_title.h"

#include <gtest/gtest.h>

namespace tactics::figure_title_test {
namespace {

struct Words {
    std::vector<ToldWords> told;
    std::vector<PrintPlace> places;

    void add(const std::string& text, double x, double y, bool set = true) {
        told.push_back({text, 100, x, y, set});
        places.push_back({{x, y}, 3});
    }
};

Words chart() {
    Words words;
    for (const double x : {20.0, 50.0, 80.0}) words.add("5", x, 92);
    words.add("Hours", 50, 97);
    return words;
}

TEST(FigureTitle, IsWhatStandsAboveAllInLinesOrAtLength) {
    Words two = chart();
    two.add("Prices of food", 50, 4);
    two.add("in Munich", 50.5, 9);
    EXPECT_EQ(take_title(two.told, two.places, {12}), "Prices of food in Munich");
    EXPECT_TRUE(two.told[4].title && two.told[5].title);
    EXPECT_FALSE(two.told[3].title);
    Words lengthy = chart();
    lengthy.add("How many pupils came to the school by bus in May", 50, 5);
    EXPECT_EQ(take_title(lengthy.told, lengthy.places, {8}), "How many pupils came to the school by bus in May");
}

TEST(FigureTitle, AtTheLeftIsLargerThanAllOtherWords) {
    const auto title_of = [](const std::string& text, double height, const std::string& next = {}) {
        Words words = chart();
        words.add(text, 9, 4);
        words.places.back().height = height;
        if (!next.empty()) {
            words.add(next, 14, 4 + 1.5 * height);
            words.places.back().height = height;
        }
        return take_title(words.told, words.places, {12});
    };
    EXPECT_EQ(title_of("stack up", 4), "stack up");
    EXPECT_EQ(title_of("Euros", 3), "") << "the name of the upright axis";
    EXPECT_EQ(title_of("Yield (t/ha)", 4), "");
    EXPECT_EQ(title_of("Share in %", 4), "");
    EXPECT_EQ(title_of("No breaks (no legend)", 4), "No breaks (no legend)");
    Words both = chart();
    both.places[3].height = 4;
    both.add("Temperature", 9, 4);
    both.places.back().height = 4;
    EXPECT_EQ(take_title(both.told, both.places, {12}), "") << "as large as the name of the other axis";
    EXPECT_EQ(title_of("Bus riders", 4, "by age and town"), "") << "half of a title is none";
}

TEST(FigureTitle, AShortOneStandsAboveAllLines) {
    Words brief = chart();
    brief.add("Prices of food", 50, 4);
    EXPECT_EQ(take_title(brief.told, brief.places, {5.4}), "") << "a box around it begins above it, or beside";
    EXPECT_EQ(take_title(brief.told, brief.places, {5.6}), "Prices of food");
}

TEST(FigureTitle, TheNameOfWhatIsRightBelowIsNone) {
    const auto title_of = [](const std::string& text, double first_ink, double height) {
        Words words = chart();
        words.add(text, 50, 5);
        words.places.back().height = height;
        return take_title(words.told, words.places, {first_ink});
    };
    for (const std::string name : {"C", "Nucleus", "R = 10 Ω", "Total = Rest", "12 345"})
        EXPECT_EQ(title_of(name, 8, 3), "") << name;
    EXPECT_EQ(title_of("Planets", 12, 3), "Planets") << "it stands free";
    EXPECT_EQ(title_of("Planets", 8, 4), "Planets") << "it is larger";
    EXPECT_EQ(title_of("Two waves", 8, 3), "Two waves") << "it says more";
    EXPECT_EQ(title_of("C", 40, 3), "");
}

// The root of a graph without boxes.
TEST(FigureTitle, IsNoWordToWhichALineLeads) {
    Words words = chart();
    words.add("River", 50, 5);
    const auto title_over = [&](const FirstInk& first) {
        Words these = words;
        return take_title(these.told, these.places, first);
    };
    EXPECT_EQ(title_over({12, 49, 51}), "");
    EXPECT_EQ(title_over({12, 10, 90}), "River") << "a chart";
    EXPECT_EQ(title_over({12, 12, 13}), "River") << "an axis at the side";
}

TEST(FigureTitle, ShortOnesInLinesAndOthersAreNames) {
    Words brief = chart();
    brief.add("Prices of food", 50, 4);
    EXPECT_EQ(take_title(brief.told, brief.places, {0}), "");
    Words unsure = chart();
    unsure.add("Prices of food", 50, 4);
    unsure.add("in Munich", 50, 9, false);
    EXPECT_EQ(take_title(unsure.told, unsure.places, {0}), "");
    Words row = chart();
    row.add("How many pupils came to the school by bus in May", 40, 5);
    row.add("North", 90, 6);
    EXPECT_EQ(take_title(row.told, row.places, {0}), "");
    for (const Words& words : {brief, unsure, row})
        for (const ToldWords& one : words.told) EXPECT_FALSE(one.title);
}

TEST(FigureTitle, TheRowsOfABoxAreNone) {
    Words box;
    for (const double y : {6.0, 14.0, 22.0}) box.add("Given name", 50, y);
    box.add("Family name", 50, 80);
    EXPECT_EQ(take_title(box.told, box.places, {2}), "") << "the box begins above them";
    EXPECT_FALSE(box.told[0].title);
}

TEST(FigureTitle, WhiteAboveItDoesNotMatter) {
    Words low;
    low.add("Prices of food", 50, 44);
    for (const double x : {20.0, 50.0, 80.0}) low.add("5", x, 92);
    EXPECT_EQ(take_title(low.told, low.places, {60}), "Prices of food");
}

TEST(FigureTitle, IsNotTheWordsOfALegend) {
    Words legend = chart();
    for (const double y : {4.0, 9.0}) {
        legend.add("Supply", 50, y);
        legend.places.back().elsewhere = true;
    }
    EXPECT_EQ(take_title(legend.told, legend.places, {100}), "");
}

}  // namespace
}  // namespace tactics::figure_title_test
