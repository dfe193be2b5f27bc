// SPDX-License-Identifier: Apache-2.0
// One chart of each kind: what is drawn lies on the data, is told apart by what the key shows, and keeps the hard rules.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "filters/chart.h"
#include "filters/contour_lines.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/shape.h"
#include "tactics/layout/lay_out.h"
#include "tactics/readers/svg/svg.h"
#include "tactics/rules/rule.h"
#include "tactics/units.h"
#include "tests/golden/golden.h"
#include "tests/print/rendered_page.h"

namespace tactics::chart_kinds_test {
namespace {

Plot waves(int count) {
    Plot plot{"Waves", {"time (s)", false}, {"height (cm)", false}, {}, {}};
    for (int k = 0; k < count; ++k) {
        plot.curves.push_back({"wave " + std::to_string(k + 1), {}});
        for (int i = 0; i <= 200; ++i)
            plot.curves.back().points.push_back({i * 0.05, 3 * k + (2 + k) * std::sin(i * 0.04 + 1.3 * k)});
    }
    return plot;
}

Plot groups() {
    Plot plot{"Groups", {"length (mm)", false}, {"width (mm)", false}, {}, {}};
    for (int k = 0; k < kSymbols; ++k)
        for (int i = 0; i < 4; ++i)
            plot.marks.push_back({i == 0 ? "group " + std::to_string(k + 1) : "", 2.0 * i + 0.4 * (k % 2),
                                  2.0 * k + 0.7 * (i % 2), static_cast<PlotSymbol>(k)});
    return plot;
}

Plot bars() {
    Plot plot{"Ages", {"age (years)", false}, {"people", false}, {}, {}};
    PlotCurve curve{"", {}, Joining::bars};
    const double heights[] = {3, 7, 12, 20, 17, 9, 0, 1, 2};
    for (int i = 0; i < 9; ++i) curve.points.push_back({i * 10.0, heights[i]});
    curve.points.push_back({90, 0});
    plot.curves.push_back(curve);
    return plot;
}

Plot steps() {
    Plot plot{"Tariff", {"hour", false}, {"price", false}, {}, {}};
    PlotCurve day{"day", {{0, 2}, {3, 5}, {6, 3}, {9, 6}, {12, 6.5}, {15, 4}, {18, 2}, {21, 5}}, Joining::steps, {4}};
    PlotCurve night{"night", {{0, 9}, {6, 8}, {12, 9.5}, {21, 8.5}}, Joining::steps};
    plot.curves = {day, night};
    return plot;
}

Plot peaks() {
    Plot plot{"Peaks", {"x (km)", false}, {"y (km)", false}, {}, {}};
    plot.z.name = "height (m)";
    PlotSurface surface;
    for (int i = 0; i <= 48; ++i) {
        surface.x.push_back(-3 + i / 8.0);
        surface.y.push_back(-3 + i / 8.0);
    }
    for (const double y : surface.y)
        for (const double x : surface.x)
            surface.z.push_back(3 * (1 - x) * (1 - x) * std::exp(-x * x - (y + 1) * (y + 1)) -
                                10 * (x / 5 - x * x * x - std::pow(y, 5)) * std::exp(-x * x - y * y) -
                                std::exp(-(x + 1) * (x + 1) - y * y) / 3);
    plot.surfaces.push_back(std::move(surface));
    return plot;
}

struct Kind {
    std::string name;
    Plot plot;
    ChartWish wish = {};
};

std::vector<Kind> kinds() {
    ChartWish grid, sections;
    grid.grid = true;
    sections.view = SurfaceView::sections;
    return {{"curves", waves(5)}, {"grid", waves(2), grid}, {"groups", groups()},           {"bars", bars()},
            {"steps", steps()},   {"contours", peaks()},    {"sections", peaks(), sections}};
}

Sheet sheet_of(const char* format) {
    const Format& its = *find_format(format);
    Sheet sheet;
    sheet.paper = find_paper(its.embosser == nullptr ? "a4" : its.paper, "test");
    sheet.medium = &find_medium(its.medium.empty() ? "swell" : its.medium, "test");
    fit_to_machine(sheet, its, Settings(its.options));
    sheet.title = "A chart";
    return sheet;
}

TEST(ChartKinds, KeepTheHardRulesOnEveryMedium) {
    for (const Kind& kind : kinds())
        for (const char* format : {"svg", "brf", "index-v4", "index-v4-floating"}) {
            const Sheet sheet = sheet_of(format);
            const Page page = lay_out(draw_chart(kind.plot, sheet, kind.wish), sheet);
            for (const Verdict& verdict : check_page(page, demands_of(*sheet.medium)))
                if (verdict.demand.rule->hard) {
                    EXPECT_TRUE(verdict.findings.places.empty())
                        << kind.name << " for " << format << ": " << verdict.findings.places[0].message.english() << " ("
                        << verdict.demand.rule->name << ") at " << verdict.findings.places[0].at.x << ", "
                        << verdict.findings.places[0].at.y;
                }
        }
}

// Millimetres of the chart as values, read from its ticks and their words as a finger reads them.
struct Reading {
    explicit Reading(const Drawing& chart) {
        for (const Stroke& stroke : chart.strokes) {
            if (stroke.role != Role::tick) continue;
            const bool upright = stroke.points[0].x == stroke.points[1].x;
            const Point tip = upright ? stroke.points[1] : stroke.points[0];
            double nearest = INFINITY, value = 0;
            for (const Label& label : chart.labels)
                if (const auto number = parse_number(label.text); number && distance(label.at, tip) < nearest) {
                    nearest = distance(label.at, tip);
                    value = *number;
                }
            (upright ? across : up).push_back({value, upright ? tip.x : tip.y});
        }
    }
    static double mm(const std::vector<std::pair<double, double>>& ticks, double value) {
        const auto& [a, from] = ticks.front();
        const auto& [b, to] = ticks.back();
        return from + (value - a) / (b - a) * (to - from);
    }
    Point at(double x, double y) const { return {mm(across, x), mm(up, y)}; }
    double field_bottom() const { return mm(up, up.front().first) + 20; }
    std::vector<std::pair<double, double>> across, up;  // value, mm
};

bool is_sample(const Stroke& stroke, const Reading& reading) { return stroke.points[0].y > reading.field_bottom() + 25; }

TEST(ChartKinds, EveryVertexOfACurveLiesOnItsData) {
    for (const Plot& plot : {waves(5), steps()}) {
        const Drawing chart = draw_chart(plot, sheet_of("svg"));
        const Reading reading(chart);
        std::vector<std::vector<Point>> lines;
        for (const PlotCurve& curve : plot.curves) {
            std::vector<Point> line;
            for (const PlotPoint& p : curve.points) {
                if (curve.joined == Joining::steps && !line.empty()) line.push_back({reading.at(p.x, 0).x, line.back().y});
                line.push_back(reading.at(p.x, p.y));
            }
            lines.push_back(line);
        }
        std::size_t looked = 0;
        for (const Stroke& stroke : chart.strokes) {
            if ((stroke.role != Role::line && stroke.role != Role::dash) || is_sample(stroke, reading)) continue;
            for (const Point& p : stroke.points) {
                double away = INFINITY;
                for (const auto& line : lines)
                    for (std::size_t i = 1; i < line.size(); ++i)
                        away = std::min(away, distance_to_segment(p, line[i - 1], line[i]));
                ASSERT_LE(away, 0.1);
                ++looked;
            }
        }
        EXPECT_GT(looked, 20u);
    }
}

TEST(ChartKinds, AGapIsFelt) {
    Plot plot{"A", {"x", false}, {"y", false}, {{"river", {}}}, {}};
    for (int i = 0; i < 40; ++i) plot.curves[0].points.push_back({i * 1.0, 5.0 + i % 2 * 0.01});
    const auto pieces = [&] {
        const Drawing chart = draw_chart(plot, sheet_of("svg"));
        const Reading reading(chart);
        std::vector<Stroke> found;
        for (const Stroke& stroke : chart.strokes)
            if (stroke.role == Role::line && !is_sample(stroke, reading)) found.push_back(stroke);
        return found;
    };
    EXPECT_EQ(pieces().size(), 1u);
    plot.curves[0].gaps = {20};
    const auto broken = pieces();
    ASSERT_EQ(broken.size(), 2u);
    EXPECT_GE(distance(broken[0].points.back(), broken[1].points.front()) - 1.0, 3.2);
    plot.curves[0].gaps = {20, 21};
    const Drawing alone = draw_chart(plot, sheet_of("svg"));
    EXPECT_EQ(alone.areas.size(), 1u) << "a point between two gaps is a disc";
}

TEST(ChartKinds, AsManySymbolsAsPointsAndOneInTheKeyForEachGroup) {
    const Plot plot = groups();
    Notes notes;
    const Drawing chart = draw_chart(plot, sheet_of("svg"), {}, &notes);
    EXPECT_TRUE(notes.empty());
    const auto symbols = [](const Drawing& drawing) {
        std::size_t outlines = 0, lines = 0;  // of crosses there are two
        for (const Stroke& stroke : drawing.strokes)
            if (stroke.role == Role::symbol) ++(stroke.closed ? outlines : lines);
        return drawing.areas.size() + outlines + lines / 2;
    };
    EXPECT_EQ(symbols(chart), plot.marks.size() + kSymbols);
    // The same points twice: one symbol each, and it is told.
    Plot twice = plot;
    for (PlotMark mark : plot.marks) {
        mark.name.clear();
        twice.marks.push_back(mark);
    }
    const Drawing merged = draw_chart(twice, sheet_of("svg"), {}, &notes);
    EXPECT_EQ(symbols(merged), symbols(chart));
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].english().find("20 of 40 points"), std::string::npos) << notes[0].english();
    EXPECT_NE(notes[0].english().find("20 at its very place"), std::string::npos) << notes[0].english();
}

TEST(ChartKinds, TheKeyShowsTheStylesOfTheCurves) {
    for (const char* format : {"svg", "brf"}) {
        const Sheet sheet = sheet_of(format);
        const Drawing chart = draw_chart(waves(5), sheet);
        const Reading reading(chart);
        std::set<std::pair<LineClass, int>> curves, samples;
        for (const Stroke& stroke : chart.strokes) {
            if (stroke.role != Role::line && stroke.role != Role::dash) continue;
            const int form = stroke.role == Role::line ? 0 : length_of(stroke) < 0.5 ? 1 : 2;
            (is_sample(stroke, reading) ? samples : curves).insert({stroke.line, form});
        }
        EXPECT_EQ(curves, samples) << format;
        EXPECT_GE(samples.size(), std::string(format) == "svg" ? 5u : 3u);
        for (int k = 1; k <= 5; ++k)
            EXPECT_EQ(std::count_if(chart.labels.begin(), chart.labels.end(),
                                    [&](const Label& label) { return label.text == "wave " + std::to_string(k); }),
                      1);
    }
}

TEST(ChartKinds, ContoursHaveTheirHeightsInABreak) {
    const Plot plot = peaks();
    ChartWish wish;
    for (const int levels : {0, 4, 8}) {
        wish.levels = levels;
        const Sheet sheet = sheet_of("svg");
        Notes notes;
        const Drawing chart = draw_chart(plot, sheet, wish, &notes);
        const Reading reading(chart);
        std::set<std::string> told;
        for (const Label& label : chart.labels)
            if (label.at.x > reading.at(-3, 0).x && label.at.y < reading.at(0, -3).y) told.insert(label.text);
        EXPECT_GE(told.size(), 3u);
        // Those without room for their words are drawn all the same, and told.
        for (const std::string& note : texts_of(notes))
            if (constexpr std::string_view kBefore = "the contour of "; note.starts_with(kBefore))
                told.insert(note.substr(kBefore.size(), note.find(" has no room") - kBefore.size()));
        for (const std::string& words : told) {
            const auto height = parse_number(words);
            ASSERT_TRUE(height) << words;
            // Lines of that height are where the surface has it.
            EXPECT_FALSE(contour_lines(plot.surfaces[0], *height).empty()) << words;
        }
        for (const Stroke& stroke : chart.strokes) {
            if (stroke.role != Role::line) continue;
            for (const Point& p : stroke.points) {
                double away = INFINITY;
                for (const std::string& words : told)
                    for (const ContourLine& line : contour_lines(plot.surfaces[0], parse_number(words).value_or(0)))
                        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i) {
                            const PlotPoint &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
                            away = std::min(away, distance_to_segment(p, reading.at(a.x, a.y), reading.at(b.x, b.y)));
                        }
                ASSERT_LE(away, 0.1);
            }
        }
    }
}

TEST(ChartKinds, SectionsAreCurvesOfTheSurface) {
    const Plot plot = peaks();
    const Plot along = sections_of(plot, plot.surfaces[0], {true, {-1, 0.06}});
    ASSERT_EQ(along.curves.size(), 2u);
    EXPECT_EQ(along.x.name, "y (km)");
    EXPECT_EQ(along.y.name, "height (m)");
    EXPECT_EQ(along.curves[0].name, "x = -1 km");
    for (std::size_t i = 0; i < 49; ++i) {
        EXPECT_EQ(along.curves[0].points[i].y, plot.surfaces[0].at(16, i));
        EXPECT_NEAR(along.curves[1].points[i].y, 0.52 * plot.surfaces[0].at(24, i) + 0.48 * plot.surfaces[0].at(25, i), 1e-9);
    }
    Plot holed = plot;
    holed.surfaces[0].z[24 * 49 + 10] = NAN;
    const Plot cut = sections_of(holed, holed.surfaces[0], {false, {0}});
    ASSERT_EQ(cut.curves[0].points.size(), 48u);
    EXPECT_EQ(cut.curves[0].gaps, std::vector<std::size_t>{10});
    EXPECT_THROW(sections_of(plot, plot.surfaces[0], {false, {9}}), Error);
    EXPECT_THROW(sections_of(plot, plot.surfaces[0], {false, {0, 1, 2, -1, -2, -3}}), Error);
    EXPECT_LE(sections_of(plot, plot.surfaces[0], {}).curves.size(), 5u);
}

TEST(ChartKinds, NoiseIsToldAndKeepsTheGap) {
    Plot plot{"Noise", {"x", false}, {"y", false}, {{"noise", {}}}, {}};
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) plot.curves[0].points.push_back({i * 0.01, static_cast<double>(random() % 1000)});
    Notes notes;
    const Sheet sheet = sheet_of("svg");
    const Page page = lay_out(draw_chart(plot, sheet, {}, &notes), sheet);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].english().find("faster than a finger can follow"), std::string::npos) << notes[0].english();
    const Demand gap{find_rule("gap"), 3.2};
    EXPECT_TRUE(check_page(page, {&gap, 1})[0].findings.places.empty());
    // Bars that narrow have nothing between them.
    plot.curves[0].joined = Joining::bars;
    EXPECT_THROW(draw_chart(plot, sheet), Error);
}

// Our own reader of SVG, and librsvg's pixels, find each curve where it was drawn.
TEST(ChartKinds, AreReadBackAsTheyWereDrawn) {
    NEED_TOOL("rsvg-convert");
    const rendered::FileFolder folder;
    for (const Kind& kind : kinds()) {
        Sheet sheet = sheet_of("svg");
        sheet.print_title = false;  // another program has other letters
        const Page page = lay_out(draw_chart(kind.plot, sheet, kind.wish), sheet);
        const std::string bytes = rendered::encode(page, "svg");
        const Page read = read_svg(bytes, "chart.svg", 12.7, std::nullopt).page;
        const auto count = [](const Page& on, Role role) {
            return std::count_if(on.strokes.begin(), on.strokes.end(), [&](const PageStroke& s) { return s.role == role; });
        };
        for (const Role role : {Role::line, Role::dash, Role::grid, Role::tick, Role::axis, Role::symbol})
            EXPECT_EQ(count(read, role), count(page, role)) << kind.name << " " << name_of(role);
        EXPECT_EQ(read.braille.size(), page.braille.size()) << kind.name;
        const auto expected = rendered::parse_png(rendered::encode(page, "png", {{"dpi", "100"}}));
        EXPECT_EQ(rendered::disagreements(expected, rendered::by_librsvg(folder, bytes, 100), 1), 0) << kind.name;
    }
}

TEST(ChartKinds, LookAsTheyDid) {
    for (const Kind& kind : kinds()) {
        const Sheet sheet = sheet_of("svg");
        const auto pixels = rendered::parse_png(
            rendered::encode(lay_out(draw_chart(kind.plot, sheet, kind.wish), sheet), "png", {{"width", "331"}}));
        Image image{pixels.width, pixels.height, 1, 1, {}};
        for (const std::uint8_t black : pixels.black) image.pixels.push_back(black != 0 ? 0 : 255);
        golden::expect_golden("charts/" + kind.name, image, 0.01);
    }
}

}  // namespace
}  // namespace tactics::chart_kinds_test
