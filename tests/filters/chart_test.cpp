// SPDX-License-Identifier: Apache-2.0
#include "filters/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "filters/ticks.h"
#include "print/format.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/label.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tactics/rules/rule.h"
#include "tactics/units.h"

namespace tactics::chart_test {
namespace {

double below(std::mt19937& random, unsigned limit) { return static_cast<double>(random() % limit); }

TEST(Ticks, ValuesThatDifferByRoundingAreOne) {
    for (const double value : {0.5, 0.66, 0.7, -3.0}) {
        const Ticks axis = ticks_for(value, std::nextafter(value, 10), false, 6);
        EXPECT_LT(axis.low, value - 1e-6);
        EXPECT_GT(axis.high, value + 1e-6);
    }
}

TEST(Ticks, AreRoundFewAndReachAround) {
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        const bool logarithmic = i % 2 == 0;
        const double size = std::pow(10.0, below(random, 13) - 6);
        double low = size * (below(random, 1000) + 1) / 100, high = low + size * below(random, 1000) / 7;
        if (!logarithmic) low -= size * 5, high -= size * 5;
        const int most = 3 + static_cast<int>(random() % 8);
        const Ticks axis = ticks_for(low, high, logarithmic, most);
        const auto& ticks = axis.at;
        ASSERT_GE(ticks.size(), 2u);
        ASSERT_LE(ticks.size(), static_cast<std::size_t>(most));
        const double slip = 1e-6 * (std::abs(low) + std::abs(high));
        EXPECT_LE(axis.low, low + slip);
        EXPECT_GE(axis.high, high - slip);
        EXPECT_LE(axis.low, ticks.front());
        EXPECT_GE(axis.high, ticks.back());
        // At most as much of a logarithmic axis is empty as lies between three neighbours of 1, 2, 5 and 10.
        if (logarithmic) {
            EXPECT_LE(std::log10(axis.high / axis.low) - std::log10(high / low), 1.01) << low << " " << high;
        } else if (high > low) {
            EXPECT_LE(axis.high - axis.low, 10 * (high - low)) << low << " " << high;
        }
        EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
        for (std::size_t k = 1; k < ticks.size(); ++k) EXPECT_GT(ticks[k], ticks[k - 1]);
        // Few digits: a tick is read with a finger. Each is a multiple of a hundredth of the largest decade of a step.
        // A wide span needs no more than itself.
        if (high > 10.1 * low && low > 0 && logarithmic) {
            EXPECT_LE(axis.high / axis.low, high / low * (1 + 1e-6));
        }
        const double step = logarithmic ? ticks[0] : ticks[1] - ticks[0];
        const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
        EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 3) < 1e-6 ||
                    std::abs(digit - 5) < 1e-6)
            << step;
    }
}

Sheet sheet_for_chart(bool print = true, bool braille = true) {
    Sheet sheet;
    sheet.paper = find_paper("A4", "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.title = "A title";
    sheet.print_title = print;
    if (!braille) sheet.braille_table.clear();
    return sheet;
}

Plot some_plot(unsigned seed, int marks) {
    std::mt19937 random(seed);
    Plot plot{"A title", {"time, ms", true}, {"share", false}, {}, {}};
    for (int i = 0; i < marks; ++i)
        plot.marks.push_back({"thing " + std::to_string(i), std::pow(10.0, below(random, 300) / 100), below(random, 1000) / 1000,
                              i % 2 == 0 ? PlotSymbol::disc : PlotSymbol::ring});
    return plot;
}

Rect box_of(const Label& label, const Sheet& sheet) {
    const LabelBlock block = set_label(label.text, sheet);
    return {label.at.x - label.across * block.width, label.at.y - label.down * block.height, block.width, block.height};
}

bool meet(const Rect& a, const Rect& b) {
    const double slip = 1e-6;
    return a.left + slip < b.left + b.width && b.left + slip < a.left + a.width && a.top + slip < b.top + b.height &&
           b.top + slip < a.top + a.height;
}

TEST(Chart, KeepsItsMillimetresOnThePage) {
    const Sheet sheet = sheet_for_chart();
    const Drawing chart = draw_chart(some_plot(1, 5), sheet);
    const Place place = place_on(sheet, chart.width / chart.height);
    EXPECT_NEAR(place.drawing.width, chart.width, 1e-6);
    EXPECT_NEAR(place.drawing.height, chart.height, 1e-6);
}

TEST(Chart, NoLabelMeetsAnotherOrLeavesTheDrawing) {
    for (const bool print : {true, false})
        for (const bool braille : {true, false}) {
            if (!print && !braille) continue;
            const Sheet sheet = sheet_for_chart(print, braille);
            for (unsigned seed = 0; seed < 20; ++seed) {
                const Drawing chart = draw_chart(some_plot(seed, 8), sheet);
                for (std::size_t i = 0; i < chart.labels.size(); ++i) {
                    const Rect box = box_of(chart.labels[i], sheet);
                    EXPECT_GE(box.left, -1e-6) << chart.labels[i].text;
                    EXPECT_GE(box.top, -1e-6) << chart.labels[i].text;
                    EXPECT_LE(box.left + box.width, chart.width + 1e-6) << chart.labels[i].text;
                    EXPECT_LE(box.top + box.height, chart.height + 1e-6) << chart.labels[i].text;
                    for (std::size_t k = 0; k < i; ++k)
                        EXPECT_FALSE(meet(box, box_of(chart.labels[k], sheet)))
                            << chart.labels[i].text << " on " << chart.labels[k].text << ", seed " << seed;
                }
            }
        }
}

// Reads the values back from the drawing as a finger would: marks against the ticks and their words.
TEST(Chart, MarksStandWhereTheTicksSay) {
    const Sheet sheet = sheet_for_chart();
    const Plot plot = some_plot(3, 6);
    const Drawing chart = draw_chart(plot, sheet);
    std::vector<std::pair<double, double>> across, up;  // mm, value
    for (const Stroke& stroke : chart.strokes) {
        if (stroke.points.size() != 2) continue;
        const Point a = stroke.points[0], b = stroke.points[1];
        const bool upright = a.x == b.x;
        double nearest = INFINITY, value = 0;
        for (const Label& label : chart.labels)
            if (const auto number = parse_number(label.text)) {
                const Point tip = upright ? b : a;
                const double away = std::hypot(label.at.x - tip.x, label.at.y - tip.y);
                if (away < nearest) nearest = away, value = *number;
            }
        (upright ? across : up).push_back({upright ? a.x : a.y, value});
    }
    ASSERT_GE(across.size(), 2u);
    ASSERT_GE(up.size(), 2u);
    const auto at = [](const auto& ticks, double mm, auto bend, auto unbend) {
        const auto& [first, low] = ticks.front();
        const auto& [last, high] = ticks.back();
        return unbend(bend(low) + (mm - first) / (last - first) * (bend(high) - bend(low)));
    };
    std::vector<Point> found;
    const auto middle = [](const std::vector<Point>& ring) {
        Point sum;
        for (const Point& p : ring) sum.x += p.x, sum.y += p.y;
        return Point{sum.x / static_cast<double>(ring.size()), sum.y / static_cast<double>(ring.size())};
    };
    for (const Area& area : chart.areas) found.push_back(middle(area.rings[0]));
    for (const Stroke& stroke : chart.strokes)
        if (stroke.closed) found.push_back(middle(stroke.points));
    ASSERT_EQ(found.size(), plot.marks.size());
    for (const PlotMark& mark : plot.marks) {
        const bool there = std::any_of(found.begin(), found.end(), [&](Point p) {
            const double x = at(
                across, p.x, [](double v) { return std::log(v); }, [](double v) { return std::exp(v); });
            const double y = at(
                up, p.y, [](double v) { return v; }, [](double v) { return v; });
            return std::abs(x / mark.x - 1) < 1e-3 && std::abs(y - mark.y) < 1e-3;
        });
        EXPECT_TRUE(there) << mark.name << " at " << mark.x << ", " << mark.y;
    }
}

// As felt on the page: from the edge of a braille dot to that of a line, a disc or the like.
double least_room(const Page& page) {
    double least = INFINITY;
    const auto take = [&](const std::vector<Point>& line, bool closed, double width) {
        for (const BrailleLine& words : page.braille)
            for (const Point& dot : dots_of(words, page.cell))
                for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
                    const Point a = line[i], b = line[(i + 1) % line.size()];
                    const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
                    const double along = square > 0 ? ((dot.x - a.x) * (b.x - a.x) + (dot.y - a.y) * (b.y - a.y)) / square : 0;
                    const double t = std::clamp(along, 0.0, 1.0);
                    const double away = distance(dot, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
                    least = std::min(least, away - width / 2 - page.braille_dot / 2);
                }
    };
    for (const PageStroke& stroke : page.strokes) take(stroke.points, stroke.closed, stroke.width);
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) take(ring, true, 0);
    return least;
}

// Measured: twelve recipes, some of them nearly equal.
Plot crowded_plot() {
    Plot plot = some_plot(0, 0);
    const double values[][2] = {{1.4, 0.193},  {1.6, 0.192},  {5.4, 0.533},  {6.9, 0.527},  {7.5, 0.547},  {7.7, 0.296},
                                {15.2, 0.616}, {15.4, 0.624}, {16.7, 0.527}, {17.5, 0.527}, {17.9, 0.493}, {25, 0.635}};
    for (const auto& [x, y] : values)
        plot.marks.push_back({"recipe", x, y, y > 0.53 || x < 1.5 ? PlotSymbol::disc : PlotSymbol::ring});
    return plot;
}

// What is drawn for a chart keeps the rules for what it is: ticks, symbols, lead lines.
TEST(Chart, KeepsTheRulesForItsParts) {
    for (const char* medium : {"swell", "thermoform", "embosser"}) {
        Sheet sheet = sheet_for_chart();
        sheet.medium = &find_medium(medium, "test");
        if (sheet.medium->name != "swell") sheet.paper = find_paper("A3", "test");
        for (unsigned seed = 0; seed < 6; ++seed) {
            const Page page = lay_out(draw_chart(some_plot(seed, 7), sheet), sheet);
            for (const std::string_view rule : {"tick-length", "tick-sides", "symbol-size", "symbol-kinds", "side-length",
                                                "area-size", "lead-width", "lead-length", "lead-arrows", "line-styles"}) {
                const Demand demand{find_rule(rule), find_rule(rule)->limit.fallback};
                const Findings findings = check_page(page, {&demand, 1})[0].findings;
                EXPECT_TRUE(findings.places.empty()) << rule << " on " << medium << ": " << findings.places[0].message.english();
            }
            EXPECT_GE(
                std::count_if(page.strokes.begin(), page.strokes.end(), [](const PageStroke& s) { return s.role == Role::tick; }),
                4);
        }
    }
}

// Curves cross and run together in any chart of data; under a finger they are still lines apart.
TEST(Chart, CurvesKeepTheGap) {
    const Sheet sheet = sheet_for_chart();
    std::mt19937 random(5);
    for (int round = 0; round < 5; ++round) {
        Plot plot{"A title", {"time, s", false}, {"share", false}, {}, {}};
        for (int k = 0; k < 4; ++k) {
            plot.curves.push_back({"curve " + std::to_string(k), {}});
            const double high = 1 + below(random, 4), phase = below(random, 6);
            for (int i = 0; i <= 200; ++i) plot.curves.back().points.push_back({i * 0.1, high * std::sin(i * 0.05 + phase)});
        }
        const Drawing chart = draw_chart(plot, sheet);
        const Page page = lay_out(chart, sheet);
        const Demand demand{find_rule("gap"), find_rule("gap")->limit.fallback};
        const Findings findings = check_page(page, {&demand, 1})[0].findings;
        EXPECT_TRUE(findings.places.empty()) << round << ": " << findings.places[0].message.english();
        // Each still has its line in the key, beside a sample of it.
        for (int k = 0; k < 4; ++k)
            EXPECT_EQ(std::count_if(chart.labels.begin(), chart.labels.end(),
                                    [&](const Label& label) { return label.text == "curve " + std::to_string(k); }),
                      1)
                << k;
    }
}

TEST(Chart, BrailleKeepsThreeMillimetresFromAllThatIsDrawn) {
    for (const bool print : {true, false}) {
        const Sheet sheet = sheet_for_chart(print);
        for (unsigned seed = 0; seed < 6; ++seed) {
            Plot plot = seed == 0 ? crowded_plot() : some_plot(seed, 11);
            PlotCurve curve;
            for (const PlotMark& mark : plot.marks)
                if (mark.symbol == PlotSymbol::disc) curve.points.push_back({mark.x, mark.y});
            std::sort(curve.points.begin(), curve.points.end(), [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
            plot.curves.push_back(std::move(curve));
            EXPECT_GE(least_room(lay_out(draw_chart(plot, sheet), sheet)), 3.0)
                << "seed " << seed << (print ? "" : " in braille only");
        }
    }
}

// Dots of a page of braille text in mm, of the cell of the upper left dot on.
std::vector<Point> dots_of_text(const std::string& text) {
    std::vector<Point> dots;
    double x = 0, y = 0;
    for (const char letter : text) {
        if (letter == '\n') x = 0, y += kMarburgMedium.line_pitch;
        if (letter < ' ') continue;
        for (std::uint8_t cell = 0; cell < 64; ++cell)
            if (brf_letter(cell) == letter)
                for (int dot = 0; dot < 6; ++dot)
                    if ((cell >> dot & 1) != 0) dots.push_back({x + 2.5 * (dot / 3), y + 2.5 * (dot % 3)});
        x += kMarburgMedium.cell_pitch;
    }
    return dots;
}

// An embosser sets words in whole cells and lines in whole dots; both move, and still nothing touches.
TEST(Chart, WordsAndLinesOfAnEmbosserKeepApart) {
    const Format& brf = *find_format("brf");
    Sheet sheet = sheet_for_chart();
    sheet.paper = find_paper(brf.paper, "test");
    sheet.medium = &find_medium(brf.medium, "test");
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Page page = lay_out(draw_chart(some_plot(seed, 8), sheet), sheet);
        Page words = page, lines = page;
        lines.braille.clear();
        words.strokes.clear();
        words.areas.clear();
        const Settings settings(brf.options);
        const auto all = dots_of_text(brf.encode(page, settings)).size();
        const auto of_words = dots_of_text(brf.encode(words, settings)), of_lines = dots_of_text(brf.encode(lines, settings));
        EXPECT_EQ(all, of_words.size() + of_lines.size()) << "nothing stands in the place of another, seed " << seed;
        std::size_t set = 0;
        for (const BrailleLine& line : page.braille) set += dots_of(line, page.cell).size();
        EXPECT_EQ(of_words.size(), set) << "seed " << seed;
        double least = INFINITY;
        for (const Point& a : of_words)
            for (const Point& b : of_lines) least = std::min(least, distance(a, b) - sheet.cell.dot);
        EXPECT_GE(least, 3.0) << "seed " << seed;
    }
}

TEST(Label, SaysWhichWordsHaveNoBraille) {
    try {
        set_label("heat \xF0\x9F\x94\xA5", sheet_for_chart());
        FAIL() << "there is no braille for fire";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("the words \"heat "), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find("--title"), std::string::npos) << error.what();
    }
}

TEST(Chart, RefusesWhatDoesNotFit) {
    EXPECT_THROW(draw_chart(Plot{}, sheet_for_chart()), Error);
    EXPECT_THROW(draw_chart(some_plot(1, 60), sheet_for_chart()), Error);
    EXPECT_NO_THROW(draw_chart(some_plot(1, 1), sheet_for_chart()));
}

TEST(Label, StaysOnThePaper) {
    const Sheet sheet = sheet_for_chart();
    Drawing drawing;
    drawing.width = 100;
    drawing.height = 100;
    drawing.labels = {{{100, 100}, 0, 0, "a corner"}, {{0, 0}, 1, 1, "another"}};
    const Page page = lay_out(drawing, sheet);
    ASSERT_EQ(page.braille.size(), 3u);  // with the title
    for (const BrailleLine& line : page.braille)
        for (const Point& dot : dots_of(line, page.cell)) {
            EXPECT_GE(dot.x, page.braille_dot / 2 - 1e-6);
            EXPECT_LE(dot.x, page.width - page.braille_dot / 2 + 1e-6);
            EXPECT_LE(dot.y, page.height - page.braille_dot / 2 + 1e-6);
        }
    drawing.labels = {{{50, 50}, 0, 0, std::string(200, 'm')}};
    EXPECT_THROW(lay_out(drawing, sheet), Error);
}

}  // namespace
}  // namespace tactics::chart_test
