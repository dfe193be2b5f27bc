// SPDX-License-Identifier: Apache-2.0
#include "print/dot_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <random>
#include <set>

namespace tactics::dot_chain_test {
namespace {

constexpr double kPi = std::numbers::pi;
const Rect kLive{7, 11, 19 * 6 + 2.5, 13 * 10 + 5};  // 20 x 14 cells, to a hair

DotGrid braille_cells() { return cell_grid(kLive, kMarburgMedium); }

// An even grid, as embossers with a pitch of their own have.
DotGrid even(double pitch) {
    DotGrid grid;
    for (int i = 0; i < 50; ++i) {
        grid.columns.push_back(5 + i * pitch);
        grid.rows.push_back(5 + i * pitch);
    }
    return grid;
}

// Number of the nearest dot plus the distance from it in the pitch of that side.
double in_pitches(double at, const std::vector<double>& centres) {
    std::size_t i = 1;
    while (i + 1 < centres.size() && centres[i] < at) ++i;
    return static_cast<double>(i) - 1 + (at - centres[i - 1]) / (centres[i] - centres[i - 1]);
}

std::vector<Point> sampled(const std::vector<Point>& points, bool closed, const DotGrid& grid) {
    std::vector<Point> samples;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i + 1 == points.size() && !closed) break;
        const Point a = points[i], b = points[(i + 1) % points.size()];
        const int steps = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / 0.06);
        for (int k = 0; k <= steps; ++k)
            samples.push_back(
                {in_pitches(a.x + (b.x - a.x) * k / steps, grid.columns), in_pitches(a.y + (b.y - a.y) * k / steps, grid.rows)});
    }
    return samples;
}

bool neighbours(GridDot a, GridDot b) { return std::abs(a.column - b.column) <= 1 && std::abs(a.row - b.row) <= 1; }

// The law of every line: connected, every dot within half a pitch of the line (and the waver), every point of the line
// within one pitch (and the waver) of a dot.
void expect_line(const std::vector<GridDot>& chain, const std::vector<Point>& points, bool closed, const DotGrid& grid,
                 const std::string& what) {
    const auto samples = sampled(points, closed, grid);
    for (std::size_t i = 1; i < chain.size(); ++i) ASSERT_TRUE(neighbours(chain[i - 1], chain[i])) << what << " dot " << i;
    for (const GridDot dot : chain) {
        double nearest = 10;
        for (const Point p : samples) nearest = std::min(nearest, std::max(std::abs(p.x - dot.column), std::abs(p.y - dot.row)));
        ASSERT_LE(nearest, 0.5 + kWaver + 0.01) << what << " dot at " << dot.column << "," << dot.row;
    }
    for (const Point p : samples) {
        double nearest = 10;
        for (const GridDot dot : chain) nearest = std::min(nearest, std::hypot(p.x - dot.column, p.y - dot.row));
        ASSERT_LE(nearest, 1 + kWaver) << what << " at " << p.x << "," << p.y;
    }
}

// Dots that stand beside the chain: the ones before and after are neighbours already.
int doubles(const std::vector<GridDot>& chain, bool closed) {
    int count = 0;
    const std::size_t n = chain.size();
    for (std::size_t i = closed ? 0 : 1; i + (closed ? 0u : 1u) < n; ++i)
        if (n > 2 && neighbours(chain[(i + n - 1) % n], chain[(i + 1) % n])) ++count;
    return count;
}

// Dots of the shortest connected way from the line's first to its last nearest dot over nearest dots of its points, found
// by breadth-first search.
std::size_t shortest(const std::vector<Point>& points, const DotGrid& grid, GridDot from, GridDot to) {
    std::set<std::pair<int, int>> open;
    for (const Point p : sampled(points, false, grid))
        open.insert({static_cast<int>(std::floor(p.x + 0.5)), static_cast<int>(std::floor(p.y + 0.5))});
    open.insert({to.column, to.row});  // an end may lie beside the nearest dot, by the waver
    std::queue<std::pair<std::pair<int, int>, std::size_t>> queue;
    queue.push({{from.column, from.row}, 1});
    open.erase({from.column, from.row});
    while (!queue.empty()) {
        const auto [at, length] = queue.front();
        queue.pop();
        if (at == std::pair(to.column, to.row)) return length;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (open.erase({at.first + dx, at.second + dy}) != 0) queue.push({{at.first + dx, at.second + dy}, length + 1});
    }
    return 0;
}

TEST(DotChain, LevelAndUprightLinesAreOneRowOfDots) {
    for (const DotGrid& grid : {braille_cells(), even(1.6)}) {
        for (double offset = 0; offset < 10; offset += 0.37) {
            const std::vector<Point> level{{20, 20 + offset}, {60, 20 + offset}}, upright{{20 + offset, 20}, {20 + offset, 70}};
            const auto across = dot_chain(level, false, grid), down = dot_chain(upright, false, grid);
            for (std::size_t i = 0; i < across.size(); ++i) {
                ASSERT_EQ(across[i].row, across[0].row);
                ASSERT_EQ(across[i].column, across[0].column + static_cast<int>(i));
            }
            for (std::size_t i = 0; i < down.size(); ++i) {
                ASSERT_EQ(down[i].column, down[0].column);
                ASSERT_EQ(down[i].row, down[0].row + static_cast<int>(i));
            }
            expect_line(across, level, false, grid, "level");
            expect_line(down, upright, false, grid, "upright");
        }
    }
}

TEST(DotChain, StraightLinesHaveNoDoublesAndAreAsShortAsCanBe) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(10, 75), y(15, 80);
    for (const DotGrid& grid : {braille_cells(), even(1.6)}) {
        for (int i = 0; i < 1500; ++i) {
            const std::vector<Point> line{{x(random), y(random)}, {x(random), y(random)}};
            const auto chain = dot_chain(line, false, grid);
            const std::string what = std::to_string(line[0].x) + "," + std::to_string(line[0].y) + " to " +
                                     std::to_string(line[1].x) + "," + std::to_string(line[1].y);
            expect_line(chain, line, false, grid, what);
            EXPECT_EQ(doubles(chain, false), 0) << what;
            EXPECT_EQ(chain.size(), shortest(line, grid, chain.front(), chain.back())) << what;
        }
    }
}

TEST(DotChain, OfAllShortestChainsTheNearest) {
    // On an even grid a line that rises less than it runs has one dot a column: the nearest in that column.
    const DotGrid grid = even(2);
    for (double rise = 0.05; rise < 1; rise += 0.0937) {
        for (double offset = 0; offset < 4; offset += 0.31) {
            const std::vector<Point> line{{21, 20 + offset}, {81, 20 + offset + 60 * rise}};
            const auto chain = dot_chain(line, false, grid);
            for (std::size_t i = 5; i + 5 < chain.size(); ++i)  // the ends may waver
                EXPECT_LE(std::abs((20 + offset + (5 + 2 * chain[i].column - 21) * rise - 5) / 2 - chain[i].row), 0.5 + 1e-9)
                    << rise << " " << offset;
        }
    }
}

TEST(DotChain, DiagonalsAtAllOffsets) {
    const DotGrid grid = even(2);
    for (double offset = 0; offset < 4; offset += 0.05) {
        const std::vector<Point> line{{20 + offset, 20}, {60 + offset, 60}};
        const auto chain = dot_chain(line, false, grid);
        for (std::size_t i = 1; i + 2 < chain.size(); ++i) {
            EXPECT_EQ(chain[i + 1].column - chain[i].column, 1) << offset;
            EXPECT_EQ(chain[i + 1].row - chain[i].row, 1) << offset;
        }
    }
}

TEST(DotChain, BackwardsIsTheSameLine) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> x(10, 110), y(15, 140);
    for (int i = 0; i < 300; ++i) {
        const std::vector<Point> line{{x(random), y(random)}, {x(random), y(random)}}, back{line[1], line[0]};
        const auto chain = dot_chain(line, false, braille_cells()), other = dot_chain(back, false, braille_cells());
        EXPECT_EQ(chain.size(), other.size());
    }
}

std::vector<Point> circle(double x, double y, double radius, int corners) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i)
        points.push_back({x + radius * std::cos(2 * kPi * i / corners), y + radius * std::sin(2 * kPi * i / corners)});
    return points;
}

TEST(DotChain, CirclesCloseWithoutDoubles) {
    for (const DotGrid& grid : {braille_cells(), even(1.6)}) {
        for (const double radius : {8.0, 15.0, 24.0}) {
            for (double offset = 0; offset < 10; offset += 0.41) {
                auto points = circle(40 + offset, 45 + offset * 0.7, radius, 500);
                std::rotate(points.begin(), points.begin() + static_cast<int>(offset * 49), points.end());  // begins anywhere
                auto chain = dot_chain(points, true, grid);
                expect_line(chain, points, true, grid, "circle");
                ASSERT_EQ(chain.front().column, chain.back().column);
                ASSERT_EQ(chain.front().row, chain.back().row);
                chain.pop_back();
                EXPECT_EQ(doubles(chain, true), 0) << radius << " at " << offset;
            }
        }
    }
}

TEST(DotChain, SpiralIsOneLine) {
    std::vector<Point> points;
    for (double a = 2; a < 10 * kPi; a += 0.01) points.push_back({67 + 1.6 * a * std::cos(a), 75 + 1.6 * a * std::sin(a)});
    const auto chain = dot_chain(points, false, braille_cells());
    expect_line(chain, points, false, braille_cells(), "spiral");
    EXPECT_EQ(doubles(chain, false), 0);
}

TEST(DotChain, CornersAreKept) {
    const DotGrid grid = braille_cells();
    for (double dx = 0; dx < 6; dx += 0.73) {
        for (double dy = 0; dy < 10; dy += 0.71) {
            const double left = 20 + dx, top = 30 + dy, right = left + 47, bottom = top + 53;
            const std::vector<Point> box{{left, top}, {right, top}, {right, bottom}, {left, bottom}};
            const auto chain = dot_chain(box, true, grid);
            std::set<std::pair<int, int>> dots, expected;
            for (const GridDot dot : chain) dots.insert({dot.column, dot.row});
            int l = 99, r = 0, t = 99, b = 0;
            for (const GridDot dot : chain) {
                l = std::min(l, dot.column), r = std::max(r, dot.column);
                t = std::min(t, dot.row), b = std::max(b, dot.row);
            }
            EXPECT_LE(std::abs(in_pitches(left, grid.columns) - l), 0.5 + kWaver);
            EXPECT_LE(std::abs(in_pitches(right, grid.columns) - r), 0.5 + kWaver);
            EXPECT_LE(std::abs(in_pitches(top, grid.rows) - t), 0.5 + kWaver);
            EXPECT_LE(std::abs(in_pitches(bottom, grid.rows) - b), 0.5 + kWaver);
            for (int c = l; c <= r; ++c) expected.insert({{c, t}, {c, b}});
            for (int k = t; k <= b; ++k) expected.insert({{l, k}, {r, k}});
            EXPECT_EQ(dots, expected) << dx << "," << dy;
        }
    }
}

TEST(DotChain, AShakingLineStaysInItsRow) {
    // Half way between two rows, 5 mm apart, the nearest dots alone would jump up and down.
    const DotGrid grid = braille_cells();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shake(-0.3, 0.3);
    std::vector<Point> line;
    for (double x = 20; x < 90; x += 0.5) line.push_back({x, (grid.rows[5] + grid.rows[6]) / 2 + shake(random)});
    const auto chain = dot_chain(line, false, grid);
    for (const GridDot dot : chain) EXPECT_EQ(dot.row, chain[0].row);
    expect_line(chain, line, false, grid, "shaking");
}

TEST(DotChain, RandomWalksObeyTheLaw) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> turn(-0.4, 0.4);
    for (int i = 0; i < 60; ++i) {
        std::vector<Point> line{{60, 75}};
        double angle = i;
        while (line.size() < 120) {
            angle += turn(random);
            line.push_back({std::clamp(line.back().x + std::cos(angle), 8.0, 110.0),
                            std::clamp(line.back().y + std::sin(angle), 12.0, 130.0)});
        }
        expect_line(dot_chain(line, false, braille_cells()), line, false, braille_cells(), "walk " + std::to_string(i));
    }
}

TEST(DotChain, CrossingsAndForksStayConnected) {
    // Strokes that end in one point end in one dot, or in neighbours when the point lies between two.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(20, 100), y(20, 120);
    for (int i = 0; i < 200; ++i) {
        const Point fork{x(random), y(random)};
        const auto a = dot_chain(std::vector<Point>{fork, {x(random), y(random)}}, false, braille_cells());
        const auto b = dot_chain(std::vector<Point>{{x(random), y(random)}, fork}, false, braille_cells());
        EXPECT_TRUE(neighbours(a.front(), b.back()));
    }
}

TEST(DotChain, OddInput) {
    const DotGrid grid = braille_cells();
    EXPECT_TRUE(dot_chain({}, false, grid).empty());
    EXPECT_EQ(dot_chain(std::vector<Point>{{30, 30}}, false, grid).size(), 1u);
    EXPECT_EQ(dot_chain(std::vector<Point>{{30, 30}, {30, 30}, {30, 30}}, true, grid).size(), 1u);
    EXPECT_THROW(dot_chain(std::vector<Point>{{30, NAN}, {30, 30}}, false, grid), std::logic_error);
    EXPECT_THROW(dot_chain(std::vector<Point>{{30, 30}, {30, 30}}, false, DotGrid{{1}, {1, 2}}), std::logic_error);
    const auto far = dot_chain(std::vector<Point>{{-1e9, -1e9}, {1e9, 1e9}}, false, grid);
    EXPECT_LT(far.size(), grid.columns.size() + grid.rows.size() + 4);
}

}  // namespace
}  // namespace tactics::dot_chain_test
