// SPDX-License-Identifier: Apache-2.0
// Bars: each ends at its value, stands on 0, is told from its neighbours, and has a name or a letter that the key explains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "filters/chart.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/texture.h"
#include "tactics/rules/rule.h"
#include "tactics/units.h"

namespace tactics::bar_chart_test {
namespace {

Plot bars_of(std::vector<std::vector<double>> values, bool stacked = false) {
    Plot plot{"Sales", {"region"}, {"tons"}, {}, {}};
    plot.bars.emplace();
    plot.bars->stacked = stacked;
    for (std::size_t i = 0; i < values.front().size(); ++i) plot.bars->categories.push_back("place " + std::to_string(i + 1));
    for (std::size_t k = 0; k < values.size(); ++k)
        plot.bars->series.push_back({values.size() > 1 ? "year " + std::to_string(k + 1) : "", values[k]});
    return plot;
}

Sheet sheet_of(const char* format, const char* paper = "a4") {
    const Format& its = *find_format(format);
    Sheet sheet;
    sheet.paper = find_paper(its.embosser == nullptr ? paper : its.paper, "test");
    sheet.medium = &find_medium(its.medium.empty() ? "swell" : its.medium, "test");
    fit_to_machine(sheet, its, Settings(its.options));
    sheet.title = "A chart";
    return sheet;
}

double mm_of(const AxisPlace& axis, double value) {
    return axis.from + (value - axis.low) / (axis.high - axis.low) * (axis.to - axis.from);
}

/// For each line of bars, its distance from 0.
std::vector<double> ends_of(const Drawing& chart, const ChartTold& told, const AxisPlace& axis) {
    std::vector<double> ends;
    for (const Stroke& stroke : chart.strokes) {
        if (stroke.role != Role::line || stroke.line != LineClass::normal) continue;
        double end = mm_of(axis, 0);
        for (const Point& p : stroke.points) {
            const double value = told.level ? p.x : p.y;
            if (std::abs(value - mm_of(axis, 0)) > std::abs(end - mm_of(axis, 0))) end = value;
        }
        ends.push_back(end);
    }
    return ends;
}

TEST(BarChart, EveryBarEndsAtItsValue) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-50, 50);
    int drawn = 0;
    for (int round = 0; round < 40; ++round) {
        std::vector<std::vector<double>> values(1 + round % 3, std::vector<double>(2 + round % 2));
        for (auto& series : values)
            for (double& value : series) do
                    value = any(random);
                while (std::abs(value) < 10);
        Plot plot = bars_of(values);
        plot.bars->way = round % 2 == 0 ? BarWay::upright : BarWay::level;
        ChartTold told;
        Drawing chart;
        try {
            chart = draw_chart(plot, sheet_of("svg", "a3"), {}, nullptr, &told);
        } catch (const Error&) {
            continue;  // upright ones have less room
        }
        ++drawn;
        ASSERT_EQ(told.level, plot.bars->way == BarWay::level);
        const AxisPlace axis = told.level ? *told.x : *told.y;
        EXPECT_LE(axis.low, 0);
        EXPECT_GE(axis.high, 0);
        const std::vector<double> ends = ends_of(chart, told, axis);
        std::size_t found = 0;
        for (const auto& series : values)
            for (const double value : series)
                found += static_cast<std::size_t>(
                    std::any_of(ends.begin(), ends.end(), [&](double end) { return std::abs(end - mm_of(axis, value)) < 1e-6; }));
        EXPECT_EQ(found, values.size() * values[0].size()) << "round " << round;
    }
    EXPECT_GT(drawn, 30);
}

TEST(BarChart, PartsOfAStackAddUpAndNegativeOnesGoDown) {
    Plot plot = bars_of({{30, -20}, {10, -40}, {20, 50}}, true);
    plot.bars->way = BarWay::level;
    ChartTold told;
    const Drawing chart = draw_chart(plot, sheet_of("svg", "a3"), {}, nullptr, &told);
    std::set<long> borders;  // of the textures, as values
    for (const Area& area : chart.areas)
        if (area.texture > 0 && area.rings[0][0].y < told.y.value_or(AxisPlace{0, 0, 300, 0}).from)
            for (const Point& p : area.rings[0]) {
                const double value =
                    told.x->low + (p.x - told.x->from) / (told.x->to - told.x->from) * (told.x->high - told.x->low);
                if (value > -65 && value < 65) borders.insert(std::lround(value * 100));
            }
    for (const long sum : {0L, 3000L, 4000L, 6000L, -2000L, -6000L, 5000L}) EXPECT_TRUE(borders.count(sum)) << sum;
    EXPECT_NEAR(told.x->low, -60, 10);
    EXPECT_NEAR(told.x->high, 60, 10);
}

TEST(BarChart, SeriesHaveATextureEachAndTheKeyHasThemAll) {
    for (std::size_t count = 2; count <= kMostSeries; ++count) {
        const Plot plot = bars_of(std::vector<std::vector<double>>(count, {9, 10}));
        const Drawing chart = draw_chart(plot, sheet_of("svg", "a3"));
        std::map<int, std::size_t> used;
        for (const Area& area : chart.areas) ++used[area.texture];
        EXPECT_EQ(used.size(), count);
        for (const auto& [texture, times] : used) EXPECT_EQ(times, 3u) << "two bars and a sample of texture " << texture;
    }
}

TEST(BarChart, BarsAndTheirGapsAreWideEnoughForAFinger) {
    for (const char* format : {"svg", "index-v4"})
        for (std::size_t clusters = 1; clusters <= 8; ++clusters) {
            Plot plot = bars_of({std::vector<double>(clusters, 10)});
            plot.bars->way = BarWay::level;
            const Drawing chart = draw_chart(plot, sheet_of(format));
            std::vector<std::pair<double, double>> spans;  // of bars, down
            const auto take = [&](const std::vector<Point>& points) {
                const auto [low, high] =
                    std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.y < b.y; });
                spans.push_back({low->y, high->y});
            };
            for (const Stroke& stroke : chart.strokes)
                if (stroke.role == Role::line && stroke.line == LineClass::normal) take(stroke.points);
            if (spans.empty())
                for (const Area& area : chart.areas) take(area.rings[0]);
            ASSERT_EQ(spans.size(), clusters) << format;
            std::sort(spans.begin(), spans.end());
            for (std::size_t i = 0; i < clusters; ++i) {
                EXPECT_GE(spans[i].second - spans[i].first, 5.0) << format;
                if (i > 0) {
                    EXPECT_GE(spans[i].first - spans[i - 1].second, 3.9) << format;
                }
            }
        }
}

TEST(BarChart, WhatHasNoRoomBelowBarsTurnsThemAndThenBecomesLetters) {
    Plot plot = bars_of({{1, 2, 3, 4}});
    ChartTold told;
    plot.bars->categories = {"a", "b", "c", "d"};
    draw_chart(plot, sheet_of("svg"), {}, nullptr, &told);
    EXPECT_FALSE(told.level);
    plot.bars->categories = {"Argentina", "Bolivia and Peru", "Chile", "Dominican Republic"};
    draw_chart(plot, sheet_of("svg"), {}, nullptr, &told);
    EXPECT_TRUE(told.level);
    EXPECT_TRUE(told.letters.empty());
    for (std::string& name : plot.bars->categories) name += " with everything that belongs to it";
    const Drawing chart = draw_chart(plot, sheet_of("svg"), {}, nullptr, &told);
    EXPECT_EQ(told.letters, (std::vector<std::string>{"a", "b", "c", "d"}));
    std::string all;
    for (const Label& label : chart.labels) all += label.text + "\n";
    for (const std::string& letter : told.letters) {
        EXPECT_NE(("\n" + all).find("\n" + letter + "\n"), std::string::npos) << "at its bar";
        EXPECT_NE(("\n" + all).find("\n" + letter + " "), std::string::npos) << "in the key";
    }
}

TEST(BarChart, TooManyAreRefusedWithHowManyHaveRoom) {
    const auto fits = [](std::size_t count) { draw_chart(bars_of({std::vector<double>(count, 10)}), sheet_of("svg")); };
    std::string why;
    try {
        fits(500);
    } catch (const Error& error) {
        why = error.what();
    }
    const auto at = why.find("has room for ");
    ASSERT_NE(at, std::string::npos) << why;
    const auto most = static_cast<std::size_t>(std::stoul(why.substr(at + 13)));
    EXPECT_GE(most, 12u) << "months of a year";
    EXPECT_NO_THROW(fits(most));
    EXPECT_THROW(fits(most + 1), Error);
}

TEST(BarChart, ErrorsReachFromLeastToLargestAndSmallOnesAreTold) {
    Plot plot = bars_of({{50, 80}});
    plot.bars->series[0].errors = {{30, 60}, {79.9, 80.1}};
    plot.bars->way = BarWay::upright;
    ChartTold told;
    Notes notes;
    const Drawing chart = draw_chart(plot, sheet_of("svg"), {}, &notes, &told);
    std::vector<double> ends;
    for (const Stroke& stroke : chart.strokes)
        if (stroke.role == Role::line && stroke.line == LineClass::thin)
            for (const Point& p : stroke.points) ends.push_back(p.y);
    for (const double value : {30.0, 60.0})
        EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [&](double y) { return std::abs(y - mm_of(*told.y, value)) < 1e-6; }),
                  3)
            << "an end and both sides of its cap";
    EXPECT_EQ(ends.size(), 8u);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].english().find("1 error is smaller"), std::string::npos);
}

TEST(BarChart, NothingIsDrawnForWhatIsNotKnownAndThatIsTold) {
    Notes notes;
    const Drawing chart = draw_chart(bars_of({{NAN, 10, 0}}), sheet_of("svg"), {}, &notes);
    EXPECT_EQ(
        std::count_if(chart.strokes.begin(), chart.strokes.end(), [](const Stroke& stroke) { return stroke.role == Role::line; }),
        1);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].english().find("1 value is not known"), std::string::npos);
    EXPECT_NO_THROW(draw_chart(bars_of({{0, 0}}), sheet_of("svg")));
}

TEST(BarChart, KeepsTheHardRulesOnEveryMedium) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-20, 100);
    std::size_t drawn = 0;
    for (int round = 0; round < 48; ++round) {
        std::vector<std::vector<double>> values(1 + round % 5, std::vector<double>(1 + round % 7));
        for (auto& series : values)
            for (double& value : series) value = any(random);
        Plot plot = bars_of(values, round % 4 == 1);
        plot.bars->way = round % 3 == 0 ? BarWay::level : BarWay::automatic;
        if (!plot.bars->stacked && round % 2 == 0)
            for (PlotSeries& series : plot.bars->series)
                for (const double value : series.values) series.errors.push_back({value - 12, value + 12});
        ChartWish wish;
        wish.grid = round % 5 == 0;
        for (const char* format : {"svg", "brf", "index-v4", "index-v4-floating"}) {
            const Sheet sheet = sheet_of(format, "a3");
            Drawing chart;
            try {
                chart = draw_chart(plot, sheet, wish);
            } catch (const Error&) {
                continue;
            }
            ++drawn;
            const Page page = lay_out(chart, sheet);
            for (const Verdict& verdict : check_page(page, demands_of(*sheet.medium)))
                if (verdict.demand.rule->hard) {
                    EXPECT_TRUE(verdict.findings.places.empty())
                        << "round " << round << " for " << format << ": " << verdict.findings.places[0].message.english() << " ("
                        << verdict.demand.rule->name << ") at " << verdict.findings.places[0].at.x << ", "
                        << verdict.findings.places[0].at.y;
                }
        }
    }
    EXPECT_GT(drawn, 80u);
}

/// The textures of the bars' long parts, in the order of their places.
std::vector<int> long_textures(const std::vector<std::vector<double>>& values) {
    const Drawing chart = draw_chart(bars_of(values, true), sheet_of("pdf"), {}, nullptr);
    std::vector<std::pair<double, int>> parts;
    for (const Area& area : chart.areas) {
        Point low{1e9, 1e9}, high{-1e9, -1e9};
        for (const Point& p : area.rings.front()) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        if (area.texture > 0 && std::max(high.x - low.x, high.y - low.y) > 60)
            parts.emplace_back(low.x + 10 * low.y, area.texture);
    }
    std::sort(parts.begin(), parts.end());
    std::vector<int> textures;
    for (const auto& [place, texture] : parts) textures.push_back(texture);
    return textures;
}

// A part too low to be felt goes into the larger one beside it, and not the other way round.
TEST(BarChart, OfAStackTheLargerPartHasItsTexture) {
    const std::vector<int> alone = long_textures({{100, 100}, {0, 0}}), first = long_textures({{100, 100}, {1, 1}}),
                           second = long_textures({{1, 1}, {100, 100}});
    ASSERT_EQ(first.size(), 2u);
    EXPECT_EQ(first, alone);
    ASSERT_EQ(second.size(), 2u);
    EXPECT_NE(second, first);
}

}  // namespace
}  // namespace tactics::bar_chart_test
