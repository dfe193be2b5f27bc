// SPDX-License-Identifier: Apache-2.0
// The page's pixels against a naive twin that asks for every pixel's centre.
#include "print/raster.h"

#include "tactics/layout/lay_out.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::raster_test {
namespace {

using namespace rendered;

double distance(const Point& p, const Point& a, const Point& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

bool inside(const Point& p, const Area& area) {
    bool odd = false;
    for (const auto& ring : area.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            if ((ring[i].y > p.y) != (ring[j].y > p.y) &&
                p.x < (ring[j].x - ring[i].x) * (p.y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
                odd = !odd;
    return odd;
}

// Black, white, or too near to an edge to say in floating point.
enum class Shade { white, black, edge };

Shade shade_at(const Page& page, const Point& p) {
    constexpr double kNear = 1e-9;
    bool edge = false;
    for (const Area& area : page.areas) {
        if (inside(p, area)) return Shade::black;
        for (const auto& ring : area.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) edge |= distance(p, ring[i], ring[(i + 1) % ring.size()]) < kNear;
    }
    for (const PageStroke& stroke : page.strokes)
        for (std::size_t i = stroke.closed ? 0 : 1; i < stroke.points.size(); ++i) {
            const Point& before = i == 0 ? stroke.points.back() : stroke.points[i - 1];
            const double d = distance(p, before, stroke.points[i]) - stroke.width / 2;
            if (d < -kNear) return Shade::black;
            edge |= d < kNear;
        }
    return edge ? Shade::edge : Shade::white;
}

std::vector<std::uint8_t> rows_of(const Page& page, PixelSize size) {
    std::vector<std::uint8_t> rows;
    draw_rows(page, size, [&](const std::uint8_t* row) { rows.insert(rows.end(), row, row + (size.width + 7) / 8); });
    return rows;
}

TEST(Raster, EveryPixelIsWhatItsCentreIs) {
    Page page;
    page.width = 40;
    page.height = 30;
    page.strokes = {{{{2, 2}, {20, 2}, {5, 9}}, false, 1.0}, {{{30, 5}, {38, 5}, {34, 14}}, true, 0.7},
                    {{{10, 20}, {10, 20}}, false, 3.0},      {{{15, 12}, {15, 28}}, false, 3.0},
                    {{{-3, 25}, {45, 27}}, false, 1.3},      {{{25, 18}, {25.01, 18}, {25.3, 18.2}}, false, 0.05}};
    page.areas = {{{ring({32, 22}, 6, 30), ring({32, 22}, 3, 7)}}, {{{{20, 10}, {28, 10}, {21, 16}, {24, 8}, {27, 16}}}}};
    for (const PixelSize size : {PixelSize{200, 150}, PixelSize{33, 41}, PixelSize{1, 1}, PixelSize{645, 7}}) {
        const auto rows = rows_of(page, size);
        ASSERT_EQ(rows.size(), static_cast<std::size_t>(size.height) * static_cast<std::size_t>((size.width + 7) / 8));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Shade want = shade_at(page, {(x + 0.5) * page.width / size.width, (y + 0.5) * page.height / size.height});
                const bool black = (rows[static_cast<std::size_t>(y * ((size.width + 7) / 8) + x / 8)] >> (7 - x % 8)) & 1;
                ASSERT_TRUE(want == Shade::edge || black == (want == Shade::black)) << x << " " << y << " of " << size.width;
            }
    }
}

TEST(Raster, BandsJoinWithoutASeam) {
    // The large one takes several bands, the small one a single band. With an odd factor the middle of each 5 x 5 block
    // has the same centre as the small pixel, so both are black or none.
    const Page page = lay_out(hard_drawing(), sheet_of("a4", "Bands"));
    const PixelSize small{1500, 2120}, large{small.width * 5, small.height * 5};
    const auto few = rows_of(page, small), many = rows_of(page, large);
    const auto at = [](const std::vector<std::uint8_t>& rows, PixelSize size, int x, int y) {
        const std::size_t row_bytes = (static_cast<std::size_t>(size.width) + 7) / 8;
        return (rows[static_cast<std::size_t>(y) * row_bytes + static_cast<std::size_t>(x / 8)] >> (7 - x % 8)) & 1;
    };
    long wrong = 0;
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) wrong += at(few, small, x, y) != at(many, large, 5 * x + 2, 5 * y + 2);
    EXPECT_LE(wrong, 2);  // centres that fall on an edge to the last bit
}

TEST(Raster, SizeFollowsTheWidthAsked) {
    Page page;
    page.width = 150;
    page.height = 100;
    EXPECT_EQ(pixels_across(page, 1501, 0, "png").height, 1001);
    EXPECT_EQ(pixels_at(page, 254, "png").width, 1500);
    EXPECT_EQ(pixels_at(page, 254, "png").height, 1000);
    page.height = 0.001;
    EXPECT_EQ(pixels_at(page, 254, "png").height, 1);
}

}  // namespace
}  // namespace tactics::raster_test
