// SPDX-License-Identifier: Apache-2.0
// What a line is to a finger: known shapes are called by their names, and turning, moving, enlarging or drawing them the
// other way round changes the words as it should and no others.
#include "tactics/geometry/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace tactics::shape_test {
namespace {

using std::numbers::pi;
using Line = std::vector<Point>;

Line bow(Point centre, double a, double b, double from, double to, int points) {
    Line line;
    for (int i = 0; i < points; ++i) {
        const double angle = from + (to - from) * i / (points - 1);
        line.push_back({centre.x + a * std::cos(angle), centre.y + b * std::sin(angle)});
    }
    return line;
}
Line ring(double a, double b) {
    Line line = bow({100, 100}, a, b, 0, 2 * pi, 61);
    line.pop_back();
    return line;
}
Line wave(int periods) {
    Line line;
    for (int i = 0; i <= 400; ++i) line.push_back({50 + i * 0.25, 100 + 3 * std::cos(2 * pi * periods * i / 400.0)});
    return line;
}

Line moved(Line line, const std::function<Point(Point)>& how) {
    for (Point& p : line) p = how(p);
    return line;
}
Line turned(const Line& line, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return moved(line, [&](Point p) {
        return Point{100 + c * (p.x - 100) - s * (p.y - 100), 100 + s * (p.x - 100) + c * (p.y - 100)};
    });
}

const Line kBox{{60, 80}, {120, 80}, {120, 110}, {60, 110}};
const Line kSquare{{60, 80}, {100, 80}, {100, 120}, {60, 120}};
const Line kTriangle{{60, 110}, {90, 60}, {130, 110}};
const Line kKite{{60, 80}, {90, 60}, {120, 80}, {90, 140}};
const Line kBent{{60, 80}, {120, 80}, {120, 110}};
const Line kZigzag{{60, 80}, {80, 120}, {100, 80}, {120, 120}, {140, 80}};
Line swing() {
    Line line;
    for (int i = 0; i <= 100; ++i) line.push_back({50.0 + i, 100 + 20 * std::sin(2 * pi * i / 100.0)});
    return line;
}
Line spiral() {
    Line line;
    for (int i = 0; i <= 400; ++i) line.push_back({100 + i * 0.1 * std::cos(i * 0.06), 100 + i * 0.1 * std::sin(i * 0.06)});
    return line;
}

struct Known {
    Line line;
    bool closed;
    std::string name;
};
const std::vector<Known> kKnown{
    {ring(20, 20), true, "circle"},
    {ring(30, 15), true, "oval"},
    {kBox, true, "rectangle"},
    {kSquare, true, "square"},
    {turned(kBox, 0.5), true, "tilted rectangle"},
    {kTriangle, true, "triangle"},
    {kKite, true, "four-sided outline"},
    {bow({100, 100}, 20, 20, 0, 2 * pi * 5 / 6, 6), true, "closed outline with 6 corners"},
    {kBent, false, "line with one corner"},
    {kZigzag, false, "line with 3 corners"},
    {swing(), false, "curved line"},
    {wave(5), false, "wavy horizontal line"},
    {turned(wave(5), pi / 2), false, "wavy vertical line"},
    {bow({100, 100}, 30, 30, -pi * 5 / 6, -pi / 6, 30), false, "arc bulging upwards"},
    {bow({100, 100}, 30, 30, 0, pi, 30), false, "arc open to the top"},
    {bow({100, 100}, 30, 30, pi / 8, 2 * pi - pi / 8, 40), false, "circle with a gap at the right"},
    {{{60, 80}, {150, 82}}, false, "straight horizontal line"},
    {{{60, 80}, {60.5, 120}}, false, "straight vertical line"},
    {{{60, 80}, {100, 60}}, false, "straight line rising to the right"},
    {{{100, 80}, {60, 60}}, false, "straight line falling to the right"},
    {{{100, 80}, {102, 81}}, false, "dot"},
    {{{100, 80}}, false, "dot"},
    {{{100, 80}, {105, 83}}, false, "small mark"},
    {spiral(), false, "winding line"},
};

TEST(Shape, KnownShapesAreCalledByTheirNames) {
    for (const Known& known : kKnown) EXPECT_EQ(shape_of(known.line, known.closed).name.english(), known.name);
}

TEST(Shape, TheWayItIsDrawnDoesNotMatter) {
    for (const Known& known : kKnown) {
        Line other = known.line;
        std::reverse(other.begin(), other.end());
        EXPECT_EQ(shape_of(other, known.closed).name.english(), known.name);
        if (known.closed) {
            std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(other.size() / 2), other.end());
            EXPECT_EQ(shape_of(other, true).name.english(), known.name);
        }
        // More points on the same course.
        Line dense;
        for (std::size_t i = 0; i + 1 < known.line.size() + (known.closed ? 1 : 0); ++i) {
            const Point a = known.line[i], b = known.line[(i + 1) % known.line.size()];
            for (int k = 0; k < 50; ++k) dense.push_back({a.x + (b.x - a.x) * k / 50, a.y + (b.y - a.y) * k / 50});
        }
        if (!known.closed) dense.push_back(known.line.back());
        EXPECT_EQ(shape_of(dense, known.closed).name.english(), known.name);
    }
}

TEST(Shape, MovingChangesNothing) {
    for (const Known& known : kKnown) {
        const Shape here = shape_of(known.line, known.closed);
        const Shape there = shape_of(moved(known.line, [](Point p) { return Point{p.x + 31, p.y - 17}; }), known.closed);
        EXPECT_EQ(there.name.english(), here.name.english());
        EXPECT_EQ(there.size.english(), here.size.english());
    }
}

TEST(Shape, TurningTurnsTheWords) {
    for (const Known& known : kKnown) {
        const std::string name = shape_of(turned(known.line, pi / 2), known.closed).name.english();
        std::string expected = known.name;
        if (expected.starts_with("straight line"))
            expected = expected == "straight line rising to the right" ? "straight line falling to the right"
                                                                       : "straight line rising to the right";
        else
            for (const auto& [before, after] : {std::pair<std::string, std::string>{"to the top", "to the right"},
                                                {"upwards", "to the right"},
                                                {"at the right", "at the bottom"},
                                                {"horizontal", "vertical"},
                                                {"vertical", "horizontal"}})
                if (const auto at = expected.find(before); at != std::string::npos) {
                    expected.replace(at, before.size(), after);
                    break;
                }
        EXPECT_EQ(name, expected) << known.name;
    }
}

TEST(Shape, EnlargingChangesTheSizeAlone) {
    for (const Known& known : kKnown) {
        if (known.name == "dot" || known.name == "small mark") continue;
        const Shape one = shape_of(known.line, known.closed);
        const Shape two = shape_of(moved(known.line, [](Point p) { return Point{2 * p.x, 2 * p.y}; }), known.closed);
        EXPECT_EQ(two.name.english(), one.name.english());
        EXPECT_NE(two.size.english(), one.size.english()) << one.name.english();
        EXPECT_NEAR(two.length, 2 * one.length, 1e-9);
    }
    EXPECT_EQ(shape_of(ring(20, 20), true).size.english(), "4 cm across");
    EXPECT_EQ(shape_of(kBox, true).size.english(), "6 cm wide and 3 cm high");
    EXPECT_EQ(shape_of(Line{{60, 80}, {150, 80}}, false).size.english(), "9 cm long");
}

TEST(Shape, LengthsAreSpokenForPeople) {
    const std::vector<std::pair<double, std::string>> spoken{{0, "1 mm"},    {3.4, "3 mm"},    {9.6, "10 mm"}, {9.8, "1 cm"},
                                                             {34, "3.5 cm"}, {97.4, "9.5 cm"}, {98, "10 cm"},  {124, "12 cm"},
                                                             {994, "99 cm"}, {1234, "1.2 m"}};
    for (const auto& [mm, words] : spoken) EXPECT_EQ(spoken_length(mm).english(), words) << mm;
}

TEST(Shape, CrossingGoesOnBeyond) {
    const auto shape = [](const Line& line, bool closed = false) { return shape_of(line, closed); };
    const Shape level = shape({{50, 100}, {150, 100}});
    EXPECT_TRUE(cross(level, shape({{100, 50}, {100, 150}})));
    EXPECT_FALSE(cross(level, shape({{100, 50}, {100, 101}})));  // ends there
    EXPECT_TRUE(end_meets(shape({{100, 50}, {100, 101}}), level));
    EXPECT_FALSE(end_meets(shape({{100, 50}, {100, 90}}), level));
    EXPECT_FALSE(cross(level, shape({{50, 110}, {150, 110}})));
    const Shape round = shape(ring(20, 20), true);
    EXPECT_TRUE(cross(level, round));
    EXPECT_FALSE(is_inside(level, round));
    EXPECT_TRUE(is_inside(shape({{95, 100}, {110, 104}}), round));
    EXPECT_FALSE(is_inside(round, shape({{95, 100}, {110, 104}})));
    EXPECT_TRUE(is_inside(round, shape(ring(40, 30), true)));
    EXPECT_FALSE(is_inside(round, shape(bow({100, 100}, 40, 40, 0, pi, 30))));  // open
}

TEST(Shape, AnyNumberOfPointsComesDownToFew) {
    Line line;
    for (int i = 0; i < 100'000; ++i)
        line.push_back({100 + 50 * std::cos(i * 1.7) * i / 1e5, 100 + 50 * std::sin(i * 2.3) * i / 1e5});
    const Shape shape = shape_of(line, false);
    EXPECT_LE(shape.corners.size(), 200u);
    EXPECT_FALSE(shape.name.empty());
}

}  // namespace
}  // namespace tactics::shape_test
