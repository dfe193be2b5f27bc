// SPDX-License-Identifier: Apache-2.0
// A large page cut into sheets: nothing is lost, nothing is added, and what two sheets share is the same on both.
#include "tactics/layout/tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tactics/layout/dot_grid.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tactics/layout/room.h"
#include "tests/print/hard_pages.h"

namespace tactics::tiles_test {
namespace {

using rendered::hard_drawing;
using rendered::picture_drawing;
using rendered::sheet_of;

constexpr double kSlip = kPageStep;  // where points of pages stand

struct Laid {
    Sheet sheet;
    Page large;
    Cut cut;
    std::vector<Page> sheets;

    Rect window(std::size_t i) const {
        const auto columns = static_cast<std::size_t>(sheet.tiles.columns);
        return {cut.window.left + static_cast<double>(i % columns) * cut.across,
                cut.window.top + static_cast<double>(i / columns) * cut.down, cut.window.width, cut.window.height};
    }
    // From the large page to that sheet.
    Point on(std::size_t i, Point p) const {
        return {p.x - window(i).left + cut.window.left, p.y - window(i).top + cut.window.top};
    }
};

bool within(const Rect& rect, Point p, double slack) {
    return p.x >= rect.left - slack && p.y >= rect.top - slack && p.x <= rect.left + rect.width + slack &&
           p.y <= rect.top + rect.height + slack;
}

Laid laid(const Drawing& drawing, int columns, int rows, const char* medium = "swell", const char* paper = "a5") {
    Laid out;
    out.sheet = sheet_of(paper, "A title of some words");
    out.sheet.medium = &find_medium(medium, "test");
    out.sheet.tiles = {columns, rows};
    out.large = lay_out(drawing, out.sheet);
    out.sheets = pages_of(drawing, out.sheet).all;
    std::erase_if(out.sheets, [](const Page& page) { return page.is_key; });
    out.cut = *cut_of(out.sheets.at(0).width, out.sheets[0].height, out.sheets[0].live, out.sheet);
    EXPECT_EQ(out.sheets.size(), static_cast<std::size_t>(columns * rows));
    return out;
}

double to_strokes(Point p, const Page& page) {
    double least = 1e9;
    for (const PageStroke& stroke : page.strokes)
        for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i) {
            const Point a = stroke.points[i], b = stroke.points[(i + 1) % stroke.points.size()];
            const double length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
            const double t =
                length > 0 ? std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length, 0.0, 1.0) : 0;
            least = std::min(least, distance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
        }
    return least;
}

bool inside(Point p, const Page& page) {
    for (const Area& area : page.areas) {
        bool in = false;
        for (const auto& ring : area.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
            }
        if (in) return true;
    }
    return false;
}

Drawing crowded() {
    Drawing drawing = hard_drawing();
    drawing.strokes[0].points.resize(1500);
    drawing.strokes.push_back({rendered::ring({90, 60}, 55, 70), true});  // across all borders
    drawing.names = {{{90, 5}, "north"}, {{35, 60}, "west side of the town"}, {{120, 90}, "market place"}};
    return drawing;
}

TEST(Tiles, EveryPointOfALineIsOnAllSheetsThatShowItsPlaceAndNoOther) {
    for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 1}, {1, 2}}) {
        const Laid all = laid(crowded(), columns, rows);
        std::size_t shared = 0;
        for (const PageStroke& stroke : all.large.strokes)
            for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i)
                for (const double t : {0.0, 0.3, 0.7}) {
                    const Point a = stroke.points[i], b = stroke.points[(i + 1) % stroke.points.size()];
                    const Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
                    std::size_t found = 0;
                    for (std::size_t k = 0; k < all.sheets.size(); ++k)
                        if (within(all.window(k), p, 0)) {
                            ++found;
                            ASSERT_LE(to_strokes(all.on(k, p), all.sheets[k]), kSlip);
                        }
                    ASSERT_GE(found, 1u) << p.x << ' ' << p.y;
                    shared += found > 1 ? 1 : 0;
                }
        EXPECT_GT(shared, 10u);
        for (std::size_t k = 0; k < all.sheets.size(); ++k)
            for (const PageStroke& stroke : all.sheets[k].strokes) {
                if (!within(all.cut.window, stroke.points[0], kSlip)) continue;  // a mark
                for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i) {
                    const Point a = stroke.points[i], b = stroke.points[(i + 1) % stroke.points.size()];
                    ASSERT_TRUE(within(all.cut.window, a, kSlip) && within(all.cut.window, b, kSlip));
                    const Point p{(a.x + b.x) / 2 + all.window(k).left - all.cut.window.left,
                                  (a.y + b.y) / 2 + all.window(k).top - all.cut.window.top};
                    ASSERT_LE(to_strokes(p, all.large), kSlip);
                }
            }
    }
}

TEST(Tiles, AreasKeepTheirInside) {
    const Laid all = laid(crowded(), 2, 3);
    std::mt19937 random(4);
    std::size_t in = 0;
    for (int i = 0; i < 20000; ++i) {
        const Point p{all.cut.whole.left + static_cast<double>(random() % 100000) / 1e5 * all.cut.whole.width,
                      all.cut.whole.top + static_cast<double>(random() % 100000) / 1e5 * all.cut.whole.height};
        for (std::size_t k = 0; k < all.sheets.size(); ++k)
            if (within(all.window(k), p, -1e-3)) {
                ASSERT_EQ(inside(all.on(k, p), all.sheets[k]), inside(p, all.large)) << p.x << ' ' << p.y;
                in += inside(p, all.large) ? 1 : 0;
            }
        for (const Page& sheet : all.sheets)
            for (const Area& area : sheet.areas)
                for (const auto& ring : area.rings)
                    for (const Point& corner : ring) ASSERT_TRUE(i > 0 || within(all.cut.window, corner, kSlip));
    }
    EXPECT_GT(in, 500u);
}

// A texture is cut like the lines that it is made of; its area goes with it.
TEST(Tiles, TexturesKeepTheirPlaceAndTheirDots) {
    for (const char* medium : {"swell", "embosser"}) {
        Drawing drawing{300, 300, {}, {}, {}};
        drawing.areas.push_back({{{{10, 10}, {290, 10}, {290, 290}, {10, 290}}}, Role::line, 1});
        const Laid out = laid(drawing, 2, 2, medium, "a4");
        EXPECT_TRUE(out.large.areas.empty());
        ASSERT_EQ(out.large.textured.size(), 1u);
        std::size_t marks = 0;
        for (std::size_t i = 0; i < out.sheets.size(); ++i) {
            const Page& sheet = out.sheets[i];
            ASSERT_EQ(sheet.textured.size(), 1u);
            EXPECT_EQ(sheet.textured[0].texture, 1);
            const DotGrid grid = cell_grid(sheet.live, sheet.cell);
            for (const PageStroke& stroke : sheet.strokes) {
                if (stroke.role != Role::pattern) continue;
                ++marks;
                if (std::string_view(medium) == "swell") continue;
                const auto off = [](const std::vector<double>& centres, double at) {
                    double least = 1e9;
                    for (const double centre : centres) least = std::min(least, std::abs(centre - at));
                    return least;
                };
                EXPECT_LT(off(grid.columns, stroke.points[0].x), kSlip) << "sheet " << i;
                EXPECT_LT(off(grid.rows, stroke.points[0].y), kSlip) << "sheet " << i;
            }
        }
        EXPECT_GT(marks, 200u);
    }
}

TEST(Tiles, PixelsKeepTheirPlace) {
    const Laid all = laid(picture_drawing(317, 203), 2, 2);
    const Bitmap& picture = *all.large.picture;
    const auto black = [](const Bitmap& bitmap, int x, int y) {
        return (bitmap.bits[static_cast<std::size_t>(y) * bitmap.row_bytes() + static_cast<std::size_t>(x / 8)] >> (7 - x % 8) &
                1) != 0;
    };
    const double across = picture.place.width / picture.width, down = picture.place.height / picture.height;
    std::size_t dark = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Point middle{picture.place.left + (x + 0.5) * across, picture.place.top + (y + 0.5) * down};
            for (std::size_t k = 0; k < all.sheets.size(); ++k) {
                if (!within(all.window(k), middle, -1e-6)) continue;
                const Bitmap& part = all.sheets[k].picture.value();
                const Point p = all.on(k, middle);
                const double column = (p.x - part.place.left) / part.place.width * part.width,
                             row = (p.y - part.place.top) / part.place.height * part.height;
                ASSERT_NEAR(column - std::floor(column), 0.5, 1e-6);
                ASSERT_TRUE(column > 0 && column < part.width && row > 0 && row < part.height);
                ASSERT_EQ(black(part, static_cast<int>(column), static_cast<int>(row)), black(picture, x, y));
                dark += black(picture, x, y) ? 1 : 0;
            }
        }
    EXPECT_GT(dark, 1000u);
}

TEST(Tiles, EveryCellIsWholeOnASheet) {
    const Laid all = laid(crowded(), 3, 3);
    std::size_t cells = 0;
    for (const BrailleLine& line : all.large.braille)
        for (std::size_t i = 0; i < line.cells.size(); ++i, ++cells) {
            const Point dot{line.first_dot.x + static_cast<double>(i) * all.large.cell.cell_pitch, line.first_dot.y};
            std::size_t found = 0;
            for (std::size_t k = 0; k < all.sheets.size(); ++k)
                for (const BrailleLine& part : all.sheets[k].braille)
                    for (std::size_t n = 0; n < part.cells.size(); ++n)
                        if (distance(all.on(k, dot), {part.first_dot.x + static_cast<double>(n) * all.large.cell.cell_pitch,
                                                      part.first_dot.y}) < kSlip) {
                            EXPECT_EQ(part.cells[n], line.cells[i]);
                            ++found;
                        }
            EXPECT_GE(found, 1u);
        }
    EXPECT_GT(cells, 30u);
}

// Where a sheet is laid on its neighbour their marks meet; they stand clear of the drawing, and outer sides have none.
TEST(Tiles, MarksMeetAndNamesTellTheOrder) {
    for (const char* medium : {"swell", "thermoform", "embosser"}) {
        const Laid all = laid(crowded(), 2, 2, medium, "a4");
        std::vector<std::vector<Point>> marks;
        for (std::size_t k = 0; k < all.sheets.size(); ++k) {
            auto& own = marks.emplace_back();
            for (const PageStroke& stroke : all.sheets[k].strokes) {
                if (within(all.cut.window, stroke.points[0], kSlip)) continue;
                for (const Point& p : stroke.points) {
                    EXPECT_FALSE(within(all.cut.window, p, all.sheet.medium->gap));
                    EXPECT_TRUE(within(all.sheets[k].live, p, kSlip));
                    own.push_back({p.x + all.window(k).left - all.cut.window.left, p.y + all.window(k).top - all.cut.window.top});
                }
                EXPECT_GE(distance(stroke.points[0], stroke.points[1]), all.sheet.medium->shortest);
            }
            EXPECT_EQ(own.size(), 8u);  // two ends of two marks on each of two inner sides
        }
        for (const auto& [one, other] : {std::pair{0u, 1u}, {0u, 2u}, {1u, 3u}, {2u, 3u}}) {
            std::size_t met = 0;
            for (const Point& p : marks[one])
                for (const Point& q : marks[other]) met += distance(p, q) < kSlip ? 1 : 0;
            EXPECT_EQ(met, 4u) << one << ' ' << other;
        }
        const std::vector<std::uint8_t> names[] = {{1, 60, 1}, {1, 60, 3}, {3, 60, 1}, {3, 60, 3}};
        for (std::size_t k = 0; k < 4; ++k) {
            const BrailleLine& name = all.sheets[k].braille.back();
            EXPECT_EQ(name.cells, names[k]);
            const Rect place = extent_of(name, all.large.cell, all.large.braille_dot);
            EXPECT_LE(place.top + place.height, all.cut.window.top - all.sheet.medium->gap + kSlip);
            EXPECT_GE(place.top, all.sheets[k].live.top - kSlip);
            for (const PageStroke& stroke : all.sheets[k].strokes)
                for (const Point& p : stroke.points) EXPECT_FALSE(within(place, p, all.sheet.medium->gap));
        }
    }
}

TEST(Tiles, MakeTheDrawingLargerThanASheet) {
    const Drawing drawing{180, 120, {Stroke{{{0, 0}, {180, 120}}}}, {}, {}};
    Sheet sheet = sheet_of("a4");
    const double alone = place_on(sheet, 1.5).drawing.width;
    sheet.tiles = {2, 2};
    EXPECT_GT(place_on(sheet, 1.5).drawing.width, 1.7 * alone);
    sheet.paper = find_paper("60x60mm", "test");
    EXPECT_THROW(place_on(sheet, 1.5), std::runtime_error);
}

}  // namespace
}  // namespace tactics::tiles_test
