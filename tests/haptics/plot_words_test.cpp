// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/plot_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactics::plot_words_test {
namespace {

Plot drive() {
    Plot plot;
    plot.x.name = "time (s)";
    plot.y.name = "speed, m/s";
    plot.curves = {{"car", {{0, 0}, {2, 8}, {4, 30}, {10, 3}}}, {"bus", {{0, 0}, {5, 20}, {10, 20}}}};
    plot.marks = {{"A", 8, 28}, {"", 1, 29}};
    return plot;
}

PlotWords words_of(Plot plot, SpokenFrame frame = {{0, 10, 100}, {0, 30, 60}}) {
    return {std::make_shared<const Plot>(std::move(plot)), frame};
}

TEST(PlotWords, SayWhatAFingerAsks) {
    const PlotWords words = words_of(drive());
    struct Case {
        Announcement asked;
        const char* said;
    };
    using enum Telling;
    for (const Case& one : {
             Case{{.telling = position, .x = 2.4999, .y = 12}, "time 2.5 s, speed 12 m/s"},
             Case{{.telling = position, .x = -1, .y = -0.5}, "time -1 s, speed -0.5 m/s"},
             Case{{.telling = position, .x = 1, .y = 2, .z = 3}, "time 1 s, speed 2 m/s, height 3"},
             Case{{.telling = nearest, .x = 1.7, .y = 8},
                  "nearest: point 2 of 4 of car, time 2 s, speed 8 m/s, 3 mm away to the right"},
             Case{{.telling = nearest, .x = 8, .y = 25.5}, "nearest: point A, time 8 s, speed 28 m/s, 5 mm away above"},
             Case{{.telling = nearest, .x = 1.5, .y = 27},
                  "nearest: point 2 of 2, time 1 s, speed 29 m/s, 6 mm away above, to the left"},
             Case{{.telling = nearest, .x = 10, .y = 3},
                  "nearest: point 4 of 4 of car, time 10 s, speed 3 m/s, under the finger"},
             Case{{.telling = under_finger, .felt = FeltPart::curve, .series = 1}, "curve bus"},
             Case{{.telling = under_finger, .felt = FeltPart::curve, .series = 2}, "nothing"},
             Case{{.telling = under_finger, .felt = FeltPart::mark, .series = 0}, "point A, time 8 s, speed 28 m/s"},
             Case{{.telling = under_finger, .felt = FeltPart::mark, .series = 9}, "nothing"},
             Case{{.telling = under_finger, .felt = FeltPart::surface, .series = 0}, "nothing"},
             Case{{.telling = under_finger, .felt = FeltPart::x_axis}, "time axis"},
             Case{{.telling = under_finger, .felt = FeltPart::x_tick, .x = 2.5}, "time axis, tick 2.5 s"},
             Case{{.telling = under_finger, .felt = FeltPart::y_grid, .y = 10}, "grid line speed 10 m/s"},
             Case{{.telling = under_finger}, "nothing"},
             Case{{.telling = curve_end, .x = 9, .y = 4}, "end of the curve car, time 10 s, speed 3 m/s"},
             Case{{.telling = curve_end, .x = 1, .y = 4}, "beginning of the curve car, time 0 s, speed 0 m/s"},
             Case{{.telling = highest}, "highest: time 4 s, speed 30 m/s"},
             Case{{.telling = lowest, .series = 1}, "lowest: time 0 s, speed 0 m/s"},
             Case{{.telling = highest, .series = 7}, "nothing"},
             Case{{.telling = comparison, .series = 0, .other = 1, .x = 3},
                  "at time 3 s: car 19 m/s, bus 12 m/s, car 7 m/s higher"},
             Case{{.telling = comparison, .series = 1, .other = 0, .x = 0}, "at time 0 s: bus 0 m/s, car 0 m/s, the same"},
             Case{{.telling = comparison, .series = 0, .other = 1, .x = 11}, "at time 11 s: car not known, bus not known"},
             // The place is a rounding beyond the end of both.
             Case{{.telling = comparison, .series = 0, .other = 1, .x = 10 * (1 + 1e-15)},
                  "at time 10 s: car 3 m/s, bus 20 m/s, bus 17 m/s higher"},
             Case{{.telling = way_end, .x = 10, .y = 3}, "end of the curve car, time 10 s, speed 3 m/s"},
             Case{{.telling = way_end, .series = 1, .x = 4, .y = 16},
                  "beginning of a piece of the curve bus, time 4 s, speed 16 m/s"},
             Case{{.telling = maximum, .x = 4, .y = 30}, "maximum of car, time 4 s, speed 30 m/s"},
             Case{{.telling = minimum, .series = 1, .x = 4, .y = 30}, "minimum of bus, time 4 s, speed 30 m/s"},
             Case{{.telling = minimum, .series = 2}, "nothing"},
             Case{{.telling = choice, .action = PlotAction::follow}, "follow"},
             Case{{.telling = hush}, ""},
         })
        EXPECT_EQ(words.of(one.asked).english(), one.said);
}

// A sentence of each kind, as a German voice reads it: with its decimal comma.
TEST(PlotWords, AreInTheLanguageOfTheVoice) {
    const PlotWords words = words_of(drive());
    const auto said = [&](const Announcement& one) { return words.of(one).in("de-AT"); };
    using enum Telling;
    EXPECT_EQ(said({.telling = position, .x = 2.5, .y = 12}), "time 2,5 s, speed 12 m/s");
    EXPECT_EQ(said({.telling = nearest, .x = 1.7, .y = 8}),
              "am n\xC3\xA4"
              "chsten: Punkt 2 von 4 der Kurve car, time 2 s, speed 8 m/s, 3 mm weiter rechts");
    EXPECT_EQ(said({.telling = under_finger, .felt = FeltPart::x_tick, .x = 2.5}), "Achse time, Teilstrich 2,5 s");
    EXPECT_EQ(said({.telling = way_end, .series = 1, .x = 4, .y = 16}),
              "Anfang eines St\xC3\xBC"
              "cks der Kurve bus, time 4 s, speed 16 m/s");
    EXPECT_EQ(said({.telling = choice, .action = PlotAction::follow}), "folgen");
}

TEST(PlotWords, AnEmptyPlotHasWords) {
    const PlotWords words = words_of({}, {});
    for (int telling = 0; telling <= static_cast<int>(Telling::choice); ++telling)
        for (int felt = 0; felt <= static_cast<int>(FeltPart::y_grid); ++felt) {
            const std::string said =
                words.of({.telling = static_cast<Telling>(telling), .felt = static_cast<FeltPart>(felt), .x = NAN, .y = INFINITY})
                    .english();
            EXPECT_EQ(said.empty(), telling == 0) << telling << " " << felt;
        }
}

TEST(PlotWords, DatesAndLogarithmsAreTheirAxes) {
    Plot plot;
    plot.x = {"day", false, true};
    plot.y = {"power [W]", true, false};
    plot.curves = {{"", {{0, 1}, {864'000, 1e6}}}};
    const PlotWords words = words_of(plot, {{0, 86'400.0 * 1000, 100}, {1, 1e6, 60}});
    EXPECT_EQ(words.of({.telling = Telling::position, .x = 864'000, .y = 1.234}).english(), "day 1970-01-11, power 1.23 W");
    EXPECT_EQ(words.of({.telling = Telling::position, .x = 864'000, .y = 123'456}).english(), "day 1970-01-11, power 123000 W");
    EXPECT_EQ(words.of({.telling = Telling::under_finger, .felt = FeltPart::curve}).english(), "curve 1");
    EXPECT_NEAR(height_of_curve(plot, plot.curves[0], 432'000), 1e3, 1e-6);  // half of the way on paper
}

// 100 x 60 x 20 mm for 10 x 30 x 4: along x 10 mm a unit, along y 2, upwards 5.
TEST(PlotWords, ASurfaceHasItsHeightAndItsSlope) {
    struct Case {
        double by_x, by_y;  // units upwards for one along
        const char* said;
    };
    for (const Case& one : {
             Case{0, 0, "surface hills, depth 2 m, level"},
             Case{0.09, 0, "surface hills, depth 2.36 m, level"},                         // 0.045
             Case{0.2, 0, "surface hills, depth 2.8 m, gentle slope, rising with time"},  // 0.1
             Case{0, -0.12, "surface hills, depth 0.8 m, slope, falling with speed"},     // 0.3
             Case{0.2, 0.04, "surface hills, depth 3.2 m, gentle slope, rising with time, rising with speed"},
             Case{-0.2, 0.01, "surface hills, depth 1.3 m, gentle slope, falling with time"},  // 14 degrees aside
             Case{3, 0, "surface hills, depth 14 m, steep slope, rising with time"},
         }) {
        Plot plot;
        plot.x.name = "time (s)";
        plot.y.name = "speed (m/s)";
        plot.z.name = "depth (m)";
        PlotSurface surface{"hills", {0, 1, 6, 10}, {0, 12, 30}, {}};
        for (const double y : surface.y)
            for (const double x : surface.x) surface.z.push_back(2 + one.by_x * x + one.by_y * y);
        plot.surfaces.push_back(surface);
        const PlotWords words = words_of(plot, {{0, 10, 100}, {0, 30, 60}, {0, 4, 20}});
        EXPECT_EQ(words.of({.telling = Telling::under_finger, .felt = FeltPart::surface, .x = 4, .y = 10}).english(), one.said);
    }
}

TEST(PlotWords, WhereASurfaceIsNotKnownNothingIsMadeUp) {
    Plot plot;
    plot.surfaces.push_back({"", {0, 1, 2}, {0, 1}, {1, 1, 1, 1, NAN, 1}});
    const PlotWords words = words_of(plot, {{0, 2, 100}, {0, 1, 60}, {0, 4, 20}});
    const auto at = [&](double x, double y) {
        return words.of({.telling = Telling::under_finger, .felt = FeltPart::surface, .x = x, .y = y}).english();
    };
    EXPECT_EQ(at(0.5, 0.5), "surface, height not known");
    EXPECT_EQ(at(-0.1, 0.5), "surface, height not known");
    EXPECT_EQ(at(NAN, 0.5), "surface, height not known");
    plot.surfaces[0].z[4] = 1;
    EXPECT_EQ(words_of(plot, {{0, 2, 100}, {0, 1, 60}, {0, 4, 20}})
                  .of({.telling = Telling::under_finger, .felt = FeltPart::surface, .x = 2, .y = 1})
                  .english(),
              "surface, height 1, level");
}

TEST(PlotWords, StepsAndGapsAreKnown) {
    Plot plot;
    PlotCurve curve{"", {{0, 1}, {1, 5}, {2, 7}}, Joining::steps, {2}};
    EXPECT_EQ(height_of_curve(plot, curve, 0.5), 1);
    EXPECT_EQ(height_of_curve(plot, curve, 1), 5);
    EXPECT_TRUE(std::isnan(height_of_curve(plot, curve, 1.5)));
    EXPECT_EQ(height_of_curve(plot, curve, 2), 7);
    curve.joined = Joining::straight;
    EXPECT_EQ(height_of_curve(plot, curve, 0.5), 3);
}

// A twin that measures on the paper, point by point.
TEST(PlotWords, TheNearestPointIsTheNearest) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0, 10), y(0, 30);
    for (int round = 0; round < 200; ++round) {
        Plot plot;
        plot.x.name = "a";
        plot.y.name = "b";
        plot.curves.resize(1);
        for (int i = 0; i < 40; ++i) plot.curves[0].points.push_back({x(random), y(random)});
        const double fx = x(random), fy = y(random);
        std::size_t nearest = 0;
        double least = 1e9;
        for (std::size_t i = 0; i < 40; ++i) {
            const double dx = (plot.curves[0].points[i].x - fx) * 10, dy = (plot.curves[0].points[i].y - fy) * 2;
            if (dx * dx + dy * dy < least) least = dx * dx + dy * dy, nearest = i;
        }
        EXPECT_TRUE(words_of(plot)
                        .of({.telling = Telling::nearest, .x = fx, .y = fy})
                        .english()
                        .starts_with("nearest: point " + std::to_string(nearest + 1) + " of 40, a "));
    }
}

}  // namespace
}  // namespace tactics::plot_words_test
