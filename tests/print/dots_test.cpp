// SPDX-License-Identifier: Apache-2.0
#include "print/dots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tactics/error.h"

namespace tactics::dots_test {
namespace {

constexpr double kPi = std::numbers::pi;
const Rect kLive{7, 11, 19 * 6 + 2.5, 13 * 10 + 5};  // 20 x 14 cells, to a hair

std::vector<Point> circle(double x, double y, double radius, int corners) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i)
        points.push_back({x + radius * std::cos(2 * kPi * i / corners), y + radius * std::sin(2 * kPi * i / corners)});
    return points;
}

TEST(Dots, GridHoldsWholeCellsOnly) {
    const auto size = [](double width, double height) {
        const DotGrid grid = cell_grid({1, 2, width, height}, kMarburgMedium);
        EXPECT_GE(grid.columns[0], 1);
        EXPECT_GE(grid.rows[0], 2);
        EXPECT_NEAR(grid.columns[0] - 1, 1 + width - grid.columns.back(), 1e-6);  // in the middle
        EXPECT_NEAR(grid.rows[0] - 2, 2 + height - grid.rows.back(), 1e-6);
        return std::pair(grid.columns.size() / 2, grid.rows.size() / 3);
    };
    EXPECT_EQ(size(39 * 6 + 2.5, 24 * 10 + 5), std::pair(std::size_t{40}, std::size_t{25}));
    EXPECT_EQ(size(39 * 6 + 2.4, 24 * 10 + 4.9), std::pair(std::size_t{39}, std::size_t{24}));
    EXPECT_EQ(size(279.4 - 12, 292.1 - 12), std::pair(std::size_t{45}, std::size_t{28}));
    EXPECT_THROW(cell_grid({0, 0, 2, 100}, kMarburgMedium), Error);
    EXPECT_THROW(cell_grid({0, 0, 100, 4}, kMarburgMedium), Error);
    EXPECT_THROW(cell_grid({0, 0, 1e9, 1e9}, kMarburgMedium), Error);
}

Page empty_page() {
    Page page;
    page.width = 134;
    page.height = 160;
    page.live = kLive;
    return page;
}

// Inside by the sum of the angles that the ring's sides are seen under: none of the code's own way.
bool inside(const Area& area, Point at) {
    int around = 0;
    for (const auto& ring : area.rings) {
        double sum = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            sum += std::remainder(std::atan2(b.y - at.y, b.x - at.x) - std::atan2(a.y - at.y, a.x - at.x), 2 * kPi);
        }
        around += static_cast<int>(std::lround(std::abs(sum) / (2 * kPi)));
    }
    return around % 2 == 1;
}

TEST(Dots, AreasAreFilledByTheEvenOddRule) {
    Page page = empty_page();
    const DotGrid grid = cell_grid(page.live, page.cell);
    page.areas.push_back({{circle(60.1, 70.2, 45, 77), circle(55.3, 65.4, 20, 31), circle(55.5, 65.1, 9, 12)}});
    const Dots dots = raise_dots(page, grid);
    for (int row = 0; row < dots.rows; ++row)
        for (int column = 0; column < dots.columns; ++column)
            EXPECT_EQ(dots.at(column, row) != 0, inside(page.areas[0], {grid.columns[static_cast<std::size_t>(column)],
                                                                        grid.rows[static_cast<std::size_t>(row)]}));
}

int count(const Dots& dots) {
    int sum = 0;
    for (const auto dot : dots.raised) sum += dot;
    return sum;
}

TEST(Dots, NarrowAreasAreNotLost) {
    for (double offset = 0; offset < 10; offset += 0.3) {
        Page page = empty_page();
        const double x = 30 + offset, y = 40 + offset;
        page.areas.push_back({{{{x, y}, {x + 60, y}, {x + 60, y + 0.4}, {x, y + 0.4}}}});
        EXPECT_GE(count(raise_dots(page, cell_grid(page.live, page.cell))), 20) << offset;
        page.areas[0] = {{circle(x, y, 0.3, 8)}};
        EXPECT_GE(count(raise_dots(page, cell_grid(page.live, page.cell))), 1) << offset;
    }
}

Bitmap bitmap(const Rect& place, double pixel, bool (*black)(double, double)) {
    Bitmap picture;
    picture.width = static_cast<int>(place.width / pixel);
    picture.height = static_cast<int>(place.height / pixel);
    picture.place = place;
    picture.bits.resize(picture.row_bytes() * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (black(place.left + (x + 0.5) * pixel, place.top + (y + 0.5) * pixel))
                picture.bits[static_cast<std::size_t>(y) * picture.row_bytes() + static_cast<std::size_t>(x / 8)] |=
                    static_cast<std::uint8_t>(0x80u >> (x % 8));
    return picture;
}

TEST(Dots, PictureRaisesWhatIsMostlyBlack) {
    Page page = empty_page();
    const DotGrid grid = cell_grid(page.live, page.cell);
    const auto disc = [](double x, double y) { return std::hypot(x - 60, y - 70) < 40; };
    page.picture = bitmap({10, 15, 110, 130}, 0.25, disc);
    const Dots dots = raise_dots(page, grid);
    for (int row = 0; row < dots.rows; ++row)
        for (int column = 0; column < dots.columns; ++column) {
            const double far =
                std::hypot(grid.columns[static_cast<std::size_t>(column)] - 60, grid.rows[static_cast<std::size_t>(row)] - 70);
            if (far < 38.5) {
                EXPECT_EQ(dots.at(column, row), 1) << column << "," << row;
            }
            if (far > 42.5) {
                EXPECT_EQ(dots.at(column, row), 0) << column << "," << row;
            }
        }
}

TEST(Dots, PictureKeepsThinLines) {
    Page page = empty_page();
    page.picture = bitmap({7, 11, 120, 140}, 0.2, [](double x, double y) { return std::abs(y - (60 + (x - 60) * 0.3)) < 0.5; });
    const DotGrid grid = cell_grid(page.live, page.cell);
    const Dots dots = raise_dots(page, grid);
    for (int column = 2; column + 2 < dots.columns; ++column) {
        int raised = 0;
        for (int row = 0; row < dots.rows; ++row) raised += dots.at(column, row);
        EXPECT_TRUE(raised == 1 || raised == 2) << column << ": " << raised;
    }
}

TEST(Dots, WhatLiesOutsideIsLeftOut) {
    Page page = empty_page();
    page.strokes.push_back({{{-50, -50}, {-50, 500}, {500, 500}}, false, 1});
    EXPECT_EQ(count(raise_dots(page, cell_grid(page.live, page.cell))), 0);
    // The live area is up to a cell larger than the grid; on its edges a line is felt on the last dots.
    page.live.height += 9.9;
    page.strokes = {{{{20, page.live.top + page.live.height}, {80, page.live.top + page.live.height}}, false, 1}};
    EXPECT_GT(count(raise_dots(page, cell_grid(page.live, page.cell))), 15);
    page.strokes = {{{{20, page.live.top}, {80, page.live.top}}, false, 1}};
    EXPECT_GT(count(raise_dots(page, cell_grid(page.live, page.cell))), 15);
}

}  // namespace
}  // namespace tactics::dots_test
