// SPDX-License-Identifier: Apache-2.0
// Rows of a table become bars: which column is what, what is added to what, and what is refused.
#include "tactics/job/table_bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tactics/error.h"
#include "tactics/job/table.h"
#include "tactics/text/number.h"

namespace tactics::table_bars_test {
namespace {

struct BarReading {
    Plot plot;
    std::vector<Phrase> notes;
};

BarReading bars(std::string_view text, TableWish wish = {}) {
    if (!wish.bars) wish.bars = BarKind::grouped;
    Source source = memory_source({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, "t");
    BarReading result;
    result.plot = plot_of(source, wish, result.notes);
    return result;
}

/// "a: North 1 South -; b: ...", what is not known as -.
std::string told(const Plot& plot) {
    std::string all;
    for (const PlotSeries& series : plot.bars->series) {
        all += (all.empty() ? "" : "; ") + series.name + ":";
        for (std::size_t i = 0; i < series.values.size(); ++i)
            all += " " + plot.bars->categories[i] + " " + (std::isnan(series.values[i]) ? "-" : to_text(series.values[i]));
    }
    return all;
}

std::string why_not(std::string_view text, const TableWish& wish = {}) {
    try {
        bars(text, wish);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(TableBars, ColumnsOfNumbersBecomeSeriesOverTheFirstColumnOfWords) {
    const std::string table = "2022,town,2023\n1,Bonn,2\n3,Trier,\n";
    const BarReading read = bars(table);
    EXPECT_EQ(told(read.plot), "2022: Bonn 1 Trier 3; 2023: Bonn 2 Trier -");
    EXPECT_EQ(read.plot.title, "2022 and 2023 by town");
    EXPECT_EQ(read.plot.x.name, "town");
    TableWish one;
    one.y = "2023";
    EXPECT_EQ(told(bars(table, one).plot), ": Bonn 2 Trier -");
    one.other_y = {"2022"};
    EXPECT_EQ(told(bars(table, one).plot), "2023: Bonn 2 Trier -; 2022: Bonn 1 Trier 3");
    EXPECT_EQ(told(bars("year,rain\n2022,5\n2023,6\n").plot), ": 2022 5 2023 6") << "no words: the first column";
    EXPECT_EQ(told(bars("rain\n5\n6\n").plot), ": 1 5 2 6") << "one column: the number of the row";
}

TEST(TableBars, RowsOfGroupsAreLaidTogether) {
    TableWish wish;
    wish.group = "year";
    const std::string table = "year,town,t\n22,A,1\n22,B,2\n23,B,4\n23,C,5\n";
    EXPECT_EQ(told(bars(table, wish).plot), "22: A 1 B 2 C -; 23: A - B 4 C 5");
    EXPECT_NE(why_not(table).find("\"B\" stands there for the second time"), std::string::npos) << why_not(table);
    std::string six = "year,town,t\n";
    for (int i = 0; i < 6; ++i) six += std::to_string(i) + ",A,1\n";
    EXPECT_NE(why_not(six, wish).find("5 textures"), std::string::npos);
}

TEST(TableBars, ErrorsAreWhatTheTableSays) {
    TableWish wish;
    wish.y = "v";
    wish.errors = {"sd"};
    const Plot plus = bars("n,v,sd\na,5,1\nb,6,\n", wish).plot;
    EXPECT_EQ(plus.bars->series[0].errors[0].low, 4);
    EXPECT_EQ(plus.bars->series[0].errors[0].high, 6);
    EXPECT_TRUE(std::isnan(plus.bars->series[0].errors[1].low));
    EXPECT_NE(why_not("n,v,sd\na,5,-1\n", wish).find("no less than 0"), std::string::npos);
    wish.errors = {};
    wish.lower = {"l"};
    EXPECT_NE(why_not("n,v,l,u\na,5,1,9\n", wish).find("go together"), std::string::npos);
    wish.upper = {"u"};
    EXPECT_EQ(bars("n,v,l,u\na,5,1,9\n", wish).plot.bars->series[0].errors[0].low, 1);
    EXPECT_NE(why_not("n,v,l,u\na,5,6,9\n", wish).find("not between"), std::string::npos);
    wish.bars = BarKind::stacked;
    EXPECT_NE(why_not("n,v,l,u\na,5,1,9\n", wish).find("grouped"), std::string::npos);
}

TEST(TableBars, APieIsSharesAndSaysWhyItIsBars) {
    TableWish wish;
    wish.bars = BarKind::pie;
    const BarReading read = bars("n,v\na,1\nb,3\n", wish);
    EXPECT_EQ(told(read.plot), ": a 25 b 75");
    EXPECT_EQ(read.plot.y.name, "percent");
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_NE(read.notes[0].english().find("lengths and not angles"), std::string::npos);
    EXPECT_NE(why_not("n,v\na,1\nb,-3\n", wish).find("less than 0"), std::string::npos);
    EXPECT_NE(why_not("n,v\na,0\n", wish).find("add up to 0"), std::string::npos);
}

TEST(TableBars, WhatBarsCannotShowIsRefused) {
    TableWish wish;
    wish.log_y = true;
    EXPECT_NE(why_not("n,v\na,1\n", wish).find("begin at 0"), std::string::npos);
    EXPECT_NE(why_not("n,v\na,NA\n").find("no column of numbers"), std::string::npos);
    EXPECT_NE(why_not("n,v\na,2024-01-01\n",
                      [] {
                          TableWish w;
                          w.y = "v";
                          return w;
                      }())
                  .find("dates"),
              std::string::npos);
    std::string many = "n,v\n";
    for (int i = 0; i <= 1000; ++i) many += "row" + std::to_string(i) + ",1\n";
    EXPECT_NE(why_not(many).find("more than 1000 bars"), std::string::npos);
}

TEST(TableBars, NumbersOfAnAxisAreWrittenAsInTheTableOrAsAsked) {
    EXPECT_FALSE(bars("n,v\na,1.5\n").plot.y.comma);
    EXPECT_TRUE(bars("n;v\na;1,5\n").plot.y.comma);
    TableWish wish;
    wish.written = Decimal::comma;
    EXPECT_TRUE(bars("n,v\na,1.5\n", wish).plot.y.comma);
}

TEST(TableBars, SeveralColumnsAreSeveralCurves) {
    TableWish wish;
    wish.x = "t";
    wish.y = "a (mm)";
    wish.other_y = {"b"};
    const std::string table = "t,a (mm),b (mm)\n1,2,3\n2,,5\n3,4,6\n";
    Source source = memory_source({reinterpret_cast<const unsigned char*>(table.data()), table.size()}, "t");
    std::vector<Phrase> notes;
    const Plot plot = plot_of(source, wish, notes);
    ASSERT_EQ(plot.curves.size(), 2u);
    EXPECT_EQ(plot.curves[0].name, "a (mm)");
    EXPECT_EQ(plot.curves[0].points.size(), 2u);
    EXPECT_EQ(plot.curves[0].gaps, std::vector<std::size_t>{1});
    EXPECT_EQ(plot.curves[1].points.size(), 3u);
    EXPECT_EQ(plot.curves[1].points[1].y, 5);
    EXPECT_EQ(plot.y.name, "mm");
    EXPECT_EQ(plot.title, "a and b against t");
    ASSERT_EQ(notes.size(), 1u);
}

}  // namespace
}  // namespace tactics::table_bars_test
