// SPDX-License-Identifier: Apache-2.0
// Lead lines past curves of very many points: no side of one is forgotten.
#include "tactics/layout/leads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tactics::leads_test {
namespace {

constexpr double kTurn = 12, kSide = 0.5;  // mm

// A coil: its turns are farther apart than two lead lines' room, so that one that is short enough meets one side only.
Page coil() {
    Page page;
    page.width = page.height = 300;
    PageStroke stroke{{}, false, 1, Role::line};
    double angle = 12;
    for (int i = 0; i < 1000; ++i) {
        const double far = kTurn * angle / 6.283185307;
        stroke.points.push_back({150 + far * std::cos(angle), 150 + far * std::sin(angle)});
        angle += kSide / far;
    }
    page.strokes.push_back(std::move(stroke));
    return page;
}

// Naive: the least distance to any side.
double away_from(Point p, const std::vector<Point>& points) {
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point a = points[i], b = points[i + 1];
        const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
        const double t = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square, 0.0, 1.0);
        least = std::min(least, distance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
    }
    return least;
}

// From one side to another of that line.
void expect_met(const Page& page, std::size_t from, std::size_t to) {
    const Leads leads(page, 0.5, 3.2);
    const auto& points = page.strokes[0].points;
    for (std::size_t i = from; i < to; ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        const Point along{(b.x - a.x) / distance(a, b), (b.y - a.y) / distance(a, b)}, out{along.y, -along.x};
        const auto at = [&](double far, double aside) {
            return Point{middle.x + far * out.x + aside * along.x, middle.y + far * out.y + aside * along.y};
        };
        ASSERT_FALSE(leads.is_clear({at(-5, 0), at(5, 0)}, false)) << i;
        ASSERT_TRUE(leads.is_clear({at(-5, 0), at(5, 0)}, true)) << i;
        ASSERT_TRUE(leads.is_clear({at(5, 0), at(0, 0)}, false)) << i;   // it ends on it
        ASSERT_FALSE(leads.is_clear({at(5, 0), at(2, 0)}, true)) << i;   // short of it
        ASSERT_FALSE(leads.is_clear({at(2, -5), at(2, 5)}, true)) << i;  // beside it
    }
    EXPECT_TRUE(leads.is_clear({{2, 2}, {20, 2}}, false));
}

TEST(Leads, MeetEverySideOfALongLine) {
    expect_met(coil(), 10, 989);
    Page ring;
    ring.width = ring.height = 300;
    ring.strokes.push_back({{}, true, 1, Role::line});
    for (int i = 0; i < 1000; ++i)
        ring.strokes[0].points.push_back({150 + 80 * std::cos(i * 0.006283185307), 150 + 80 * std::sin(i * 0.006283185307)});
    expect_met(ring, 0, 1000);
}

// The ink that is nearest, and on both sides of it as far as the way along the line says.
TEST(Leads, EndOnTheNearestInkOfALongLine) {
    const Page page = coil();
    const Leads leads(page, 0.5, 3.2);
    const auto& points = page.strokes[0].points;
    for (std::size_t i = 20; i + 20 < points.size(); ++i) {
        const Point thing{points[i].x + 0.3, points[i].y + 0.4};
        const auto ends = leads.ends_for(thing);
        ASSERT_EQ(ends.size(), 5u) << i;
        EXPECT_NEAR(distance(ends[0], thing), away_from(thing, points), 1e-9) << i;
        for (std::size_t k = 0; k < ends.size(); ++k) {
            EXPECT_NEAR(away_from(ends[k], points), 0, 1e-9) << i;
            EXPECT_NEAR(distance(ends[k], ends[0]), k == 0 ? 0 : k < 3 ? 2 : 4, 0.05) << i << ' ' << k;
        }
    }
}

// On a line a finger does not leave it where the lead line does; at the end of one it takes both for one line.
TEST(Leads, CrossWhatTheyRunOnAndTheEndsOfLines) {
    Page page;
    page.width = page.height = 200;
    page.strokes.push_back({{{50, 100}, {90, 100}}, false, 1, Role::line});
    page.strokes.push_back({{{120, 50}, {150, 50}, {150, 80}, {120, 80}}, true, 1, Role::line});
    for (int quarter = 0; quarter < 4; ++quarter) {
        SCOPED_TRACE(quarter);
        const Leads leads(page, 0.5, 3.2);
        const auto crossings = [&](Point from, Point to) {
            for (int i = 0; i < quarter; ++i) from = {200 - from.y, from.x}, to = {200 - to.y, to.x};
            return leads.crossings({from, to});
        };
        EXPECT_EQ(crossings({40, 100}, {80, 100}), 1u);      // on it
        EXPECT_EQ(crossings({100, 100}, {60, 100}), 1u);     // the other way
        EXPECT_EQ(crossings({40, 100.5}, {80, 100.5}), 1u);  // beside it, as if on it
        EXPECT_EQ(crossings({135, 79.5}, {165, 79.5}), 1u);  // on a side, across another
        EXPECT_EQ(crossings({90, 80}, {90, 120}), 1u);       // its end
        EXPECT_EQ(crossings({90.5, 80}, {90.5, 120}), 1u);   // right beside its end
        EXPECT_EQ(crossings({92, 80}, {92, 120}), 0u);
        EXPECT_EQ(crossings({70, 80}, {70, 120}), 1u);
        EXPECT_EQ(crossings({70, 80}, {70, 100}), 0u);  // it ends there
        EXPECT_EQ(crossings({120, 100}, {90, 100}), 0u);
        EXPECT_EQ(crossings({60, 90}, {80, 90}), 0u);
        for (PageStroke& stroke : page.strokes)
            for (Point& p : stroke.points) p = {200 - p.y, p.x};
    }
}

}  // namespace
}  // namespace tactics::leads_test
