// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tactics::room_test {
namespace {

// Between a line without width and a rectangle, from many places along the line.
double distance_between(const PageStroke& stroke, const Rect& rect) {
    double least = 1e9;
    for (int i = 0; i <= 2000; ++i) {
        const double t = i / 2000.0;
        const Point p{stroke.points[0].x + t * (stroke.points[1].x - stroke.points[0].x),
                      stroke.points[0].y + t * (stroke.points[1].y - stroke.points[0].y)};
        least = std::min(least, distance(p, nearest_of(rect, p)));
    }
    return least;
}

TEST(Room, IsFreeAsFarFromLinesAsAskedAndOnTheLivePartOnly) {
    std::mt19937 random(7);
    const auto any = [&](double from, double to) { return from + (to - from) * static_cast<double>(random()) / 4294967296.0; };
    int free = 0, taken = 0;
    for (const double clear : {0.2, 1.0, 3.4, 6.0, 40.0}) {
        Page page;
        page.width = 120;
        page.height = 90;
        page.live = {10, 8, 100, 75};
        for (int i = 0; i < (clear > 10 ? 1 : 5); ++i) {
            PageStroke stroke;
            stroke.points = {{any(0, 120), any(0, 90)}, {any(0, 120), any(0, 90)}};
            stroke.width = 0;
            page.strokes.push_back(stroke);
        }
        const Room room(page, clear);
        for (int i = 0; i < 400; ++i) {
            const Rect rect{any(-5, 115), any(-5, 85), any(0.5, 20), any(0.5, 12)};
            double away = 1e9;
            for (const PageStroke& stroke : page.strokes) away = std::min(away, distance_between(stroke, rect));
            // How far it is within the live part, less than 0 if it reaches out.
            const double within =
                std::min({rect.left - 10, rect.top - 8, 110 - rect.left - rect.width, 83 - rect.top - rect.height});
            constexpr double kSquare = 0.5;
            if (room.is_free(rect)) {
                ++free;
                EXPECT_GE(away, clear - 0.01) << clear;
                EXPECT_GE(within, -1e-9) << clear;
            } else {
                ++taken;
                EXPECT_TRUE(away < clear + 4 * kSquare || within < kSquare) << clear << " " << away << " " << within;
            }
        }
    }
    EXPECT_GT(free, 100);
    EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace tactics::room_test
