// SPDX-License-Identifier: Apache-2.0
// Lines of print that make one label, and lines beside them that do not.
#include "tactics/job/label_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tactics::label_lines_test {
namespace {

// Letters are 7 high and 6 wide, lines of a label 12 apart.
class Print {
public:
    Print& line(const std::string& text, double middle, double y, bool centred = false) {
        const double half = 3.0 * static_cast<double>(text.size());
        told_.push_back({text, 90, middle, y, true, {middle, y}});
        lines_.push_back({{middle - half, y - 3.5, middle + half, y + 3.5}, 7, false, centred});
        return *this;
    }
    ToldWords& last() { return told_.back(); }

    std::vector<std::string> joined() {
        join_label_lines(told_, lines_,
                         {[this](const Box& place) { return !meet(place, ruled_); },
                          [this](Point one, Point other) { return thing_.holds(one) && thing_.holds(other); }});
        std::vector<std::string> texts;
        for (const ToldWords& one : told_) texts.push_back(one.text);
        return texts;
    }

    Box ruled_ = kNothing, thing_ = kNothing;
    std::vector<ToldWords> told_;

private:
    std::vector<PlacedLine> lines_;
};

using Texts = std::vector<std::string>;

TEST(LabelLines, BelowEachOtherInTheMiddleAreOneLabel) {
    Print print;
    EXPECT_EQ(print.line("Host", 100, 50).line("elsewhere", 300, 50).line("Frontend", 100, 62).joined(),
              (Texts{"Host Frontend", "elsewhere"}));
    EXPECT_EQ(print.told_.front().y, 56);
    EXPECT_EQ(print.told_.front().wanted.y, 56);
    EXPECT_EQ(Print().line("half", 100, 50).line("side", 100, 62, true).joined(), (Texts{"half", "side"}));
    EXPECT_EQ(Print().line("half-", 100, 50, true).line("sided", 100, 62, true).joined(), (Texts{"half-sided"}));
    EXPECT_EQ(Print().line("a b c d", 100, 50).line("e f", 100, 62).line("g h i j k", 100, 74).joined(),
              (Texts{"a b c d e f g h i j k"}));
}

TEST(LabelLines, ListsAndColumnsAreNone) {
    const auto flush = [](double left, const std::string& text) { return left + 3.0 * static_cast<double>(text.size()); };
    EXPECT_EQ(Print().line("Boys", flush(50, "Boys"), 50).line("Girls and", flush(50, "Girls and"), 62).joined().size(), 2u);
    EXPECT_EQ(Print().line("Wed", 100 - 9, 50).line("Thursday", 100 - 24, 62).joined().size(), 2u);  // flush right
    EXPECT_EQ(Print().line("10", 100, 50, true).line("2000", 100, 62, true).joined().size(), 2u);
    EXPECT_EQ(Print().line("Host", 100, 50).line("Frontend", 100, 66).joined().size(), 2u);  // the name of an axis is so far off
}

TEST(LabelLines, WhatIsBelowNamesOfAnAxisIsItsName) {
    Print print;
    for (const double x : {40.0, 100.0, 160.0}) print.line(x == 100 ? "Mar" : "Ap", x, 50, true);
    EXPECT_EQ(print.line("Month of", 100, 62, true).joined().size(), 4u);
    EXPECT_EQ(Print().line("5", 40, 50, true).line("6", 100, 50, true).line("Years", 40, 62, true).joined().size(), 3u);
    EXPECT_EQ(Print().line("Layer", 40, 50, true).line("6", 40, 62, true).joined(), (Texts{"Layer 6"}));
}

TEST(LabelLines, ALineBetweenThemPartsThem) {
    Print print;
    print.ruled_ = {0, 55.9, 200, 56.1};
    EXPECT_EQ(print.line("Host", 100, 50).line("Frontend", 100, 62).joined().size(), 2u);
}

TEST(LabelLines, WithinOneThingTheyMayBeFartherApart) {
    Print print;
    print.thing_ = {50, 40, 150, 80};
    EXPECT_EQ(print.line("Host", 100, 50).line("Frontend", 100, 68).joined(), (Texts{"Host Frontend"}));
}

TEST(LabelLines, WhatIsToldOrStandsElsewhereStaysAlone) {
    Print told;
    told.line("Host", 100, 50).line("Frontend", 100, 62).last().set = false;
    EXPECT_EQ(told.joined().size(), 2u);
    Print title;
    title.line("Host", 100, 50).last().title = true;
    EXPECT_EQ(title.line("Frontend", 100, 62).joined().size(), 2u);
    Print legend;
    legend.line("Host", 100, 50).last().wanted = {20, 20};
    EXPECT_EQ(legend.line("Frontend", 100, 62).joined().size(), 2u);
}

}  // namespace
}  // namespace tactics::label_lines_test
