// SPDX-License-Identifier: Apache-2.0
// Curves through lines stay on them, have few nodes and keep corners.
#include "tactics/geometry/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tactics/geometry/course.h"

namespace tactics::curves_test {
namespace {

constexpr double kTolerance = 0.05;

std::vector<Point> flattened(Point from, const std::vector<CurvePiece>& pieces) {
    std::vector<Point> out{from};
    for (const CurvePiece& piece : pieces) {
        const int steps = piece.straight ? 1 : 40;
        for (int i = 1; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps, s = 1 - t;
            if (piece.straight) {
                out.push_back(piece.end);
                continue;
            }
            const double a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t, d = t * t * t;
            out.push_back({a * from.x + b * piece.one.x + c * piece.other.x + d * piece.end.x,
                           a * from.y + b * piece.one.y + c * piece.other.y + d * piece.end.y});
        }
        from = piece.end;
    }
    return out;
}

double off(Point p, const std::vector<Point>& line) {
    double least = INFINITY;
    for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
    return least;
}

// Every place of one is near the other, both ways.
double apart(const std::vector<Point>& a, const std::vector<Point>& b) {
    double most = 0;
    for (const auto& [of, to] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t i = 1; i < of->size(); ++i)
            for (const double t : {0.0, 0.5})
                most = std::max(most, off({(*of)[i - 1].x + t * ((*of)[i].x - (*of)[i - 1].x),
                                           (*of)[i - 1].y + t * ((*of)[i].y - (*of)[i - 1].y)},
                                          *to));
    return most;
}

std::vector<Point> circle(double radius, int points) {
    std::vector<Point> out;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        out.push_back({100 + radius * std::cos(angle), 100 + radius * std::sin(angle)});
    }
    return out;
}

TEST(Curves, ACircleHasFewNodes) {
    const std::vector<Point> ring = circle(30, 400);
    const auto pieces = curves_of(ring, true, kTolerance);
    EXPECT_GE(pieces.size(), 2u);
    EXPECT_LE(pieces.size(), 8u);
    EXPECT_EQ(distance(pieces.back().end, ring.front()), 0);
    std::vector<Point> whole = ring;
    whole.push_back(ring.front());
    EXPECT_LE(apart(flattened(ring.front(), pieces), whole), 1.05 * kTolerance);
}

TEST(Curves, CornersStay) {
    const std::vector<Point> square{{0, 0}, {40, 0}, {40, 40}, {0, 40}};
    const auto pieces = curves_of(square, true, kTolerance);
    ASSERT_EQ(pieces.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(pieces[i].straight);
        EXPECT_EQ(distance(pieces[i].end, square[(i + 1) % 4]), 0);
    }
}

TEST(Curves, LinesByChanceAreFollowed) {
    std::mt19937 chance(7);
    std::uniform_real_distribution<double> turn(-0.25, 0.25), jitter(-0.02, 0.02), sharp(0, 1);
    for (int round = 0; round < 24; ++round) {
        std::vector<Point> line{{50, 50}};
        double way = 0, bend = 0;
        const double step = round % 3 == 0 ? 0.2 : round % 3 == 1 ? 1 : 4;
        for (int i = 0; i < 150; ++i) {
            bend = 0.8 * bend + turn(chance) * 0.5;
            way += bend;
            if (sharp(chance) < 0.03) way += 2;
            const Point last = line.back();
            line.push_back({last.x + step * std::cos(way) + jitter(chance), last.y + step * std::sin(way) + jitter(chance)});
        }
        const bool closed = round % 2 == 1;
        const auto pieces = curves_of(line, closed, kTolerance);
        std::vector<Point> whole = line;
        if (closed) whole.push_back(line.front());
        EXPECT_EQ(distance(pieces.back().end, whole.back()), 0) << round;
        EXPECT_LE(apart(flattened(line.front(), pieces), whole), 1.3 * kTolerance) << round;
    }
}

TEST(Curves, NothingIsTooLittle) {
    EXPECT_TRUE(curves_of({}, false, kTolerance).empty());
    EXPECT_TRUE(curves_of({{1, 1}}, true, kTolerance).empty());
    EXPECT_EQ(curves_of({{1, 1}, {1, 1}}, false, kTolerance).size(), 1u);
    EXPECT_EQ(curves_of({{1, 1}, {1, 1}, {1, 1}}, true, kTolerance).back().end.x, 1);
}

}  // namespace
}  // namespace tactics::curves_test
