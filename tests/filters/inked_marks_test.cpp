// SPDX-License-Identifier: Apache-2.0
// Points of a plot in a picture, told from what looks like them. The forms are painted here, each pixel in sixteen places.
#include "filters/inked_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "filters/darken.h"
#include "filters/inked_points.h"
#include "filters/mark_forms.h"
#include "filters/plot_symbols.h"
#include "tests/filters/pictures.h"

namespace tactics::inked_marks_test {
namespace {

using Pixel = std::array<int, 3>;
using Shape = std::function<bool(double, double)>;
constexpr Pixel kBlack{0, 0, 0}, kRed{214, 39, 40}, kBlue{31, 119, 180};

struct Painting {
    Image picture = make_image(400, 300, 3, 0.2, 255);

    void paint(const Shape& shape, const Pixel& colour = kBlack) {
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                int inside = 0;
                for (int i = 0; i < 16; ++i) inside += shape(x + (i % 4 + 0.5) / 4, y + (i / 4 + 0.5) / 4) ? 1 : 0;
                std::uint8_t* pixel = picture.row(y) + 3 * x;
                for (std::size_t c = 0; c < 3; ++c)
                    pixel[c] = static_cast<std::uint8_t>((pixel[c] * (16 - inside) + colour[c] * inside) / 16);
            }
    }
    InkedMarks marks() const { return inked_marks_in(picture, ink_on_white(picture), 6, 40); }
};

double off_line(double x, double y, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y,
                 t = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}
Shape line(Point a, Point b, double width) {
    return [=](double x, double y) { return off_line(x, y, a, b) <= width / 2; };
}
Shape disc(Point at, double r) {
    return [=](double x, double y) { return std::hypot(x - at.x, y - at.y) <= r; };
}
Shape ring(Point at, double r) {
    return [=](double x, double y) { return std::abs(std::hypot(x - at.x, y - at.y) - r + 0.8) <= 0.8; };
}
Shape square(Point at, double r) {
    return [=](double x, double y) { return std::max(std::abs(x - at.x), std::abs(y - at.y)) <= r; };
}
Shape open_square(Point at, double r) {
    return [=](double x, double y) { return std::abs(std::max(std::abs(x - at.x), std::abs(y - at.y)) - r + 0.8) <= 0.8; };
}
Shape triangle(Point at, double r) {
    return [=](double x, double y) { return y - at.y <= r && std::abs(x - at.x) <= (y - at.y + r) / 2; };
}
Shape cross(Point at, double r) {
    return [=](double x, double y) {
        return std::min(off_line(x, y, {at.x - r, at.y - r}, {at.x + r, at.y + r}),
                        off_line(x, y, {at.x - r, at.y + r}, {at.x + r, at.y - r})) <= 1;
    };
}
using Form = Shape (*)(Point, double);

// Not in rows.
std::vector<Point> scattered(Point from, std::size_t count) {
    std::vector<Point> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({from.x + 31 * static_cast<double>(i) + 0.3 * static_cast<double>(i % 3),
                          from.y + 17 * static_cast<double>(i * i % 5)});
    return places;
}

std::size_t found_at(const InkedMarks& found, const std::vector<Point>& places, PlotSymbol symbol) {
    return static_cast<std::size_t>(std::count_if(places.begin(), places.end(), [&](Point at) {
        return std::any_of(found.marks.begin(), found.marks.end(), [&](const InkedMark& mark) {
            return distance(mark.middle, at) < 1.6 && found.symbols[mark.kind] == symbol;
        });
    }));
}

TEST(InkedMarks, EachFormGetsTheSymbolThatIsNearestToIt) {
    for (const auto& [form, symbol] : {std::pair<Form, PlotSymbol>{disc, PlotSymbol::disc},
                                       {ring, PlotSymbol::ring},
                                       {square, PlotSymbol::square},
                                       {open_square, PlotSymbol::square},
                                       {triangle, PlotSymbol::triangle},
                                       {cross, PlotSymbol::cross}})
        for (const double radius : {5.0, 8.0, 12.0}) {
            Painting painting;
            const std::vector<Point> places = scattered({30, 60}, 9);
            for (const Point at : places) painting.paint(form(at, radius));
            const InkedMarks found = painting.marks();
            EXPECT_EQ(found_at(found, places, symbol), places.size()) << static_cast<int>(symbol) << ' ' << radius;
            EXPECT_EQ(found.marks.size(), places.size());
            EXPECT_EQ(found.symbols.size(), 1u);
        }
}

TEST(InkedMarks, ColoursOfOneFormGetSymbolsOfTheirOwn) {
    Painting painting;
    const std::vector<Point> reds = scattered({30, 40}, 8), blues = scattered({40, 150}, 8);
    for (const Point at : reds) painting.paint(disc(at, 6), kRed);
    for (const Point at : blues) painting.paint(disc(at, 6), kBlue);
    const InkedMarks found = painting.marks();
    ASSERT_EQ(found.symbols.size(), 2u);
    EXPECT_NE(found.symbols[0], found.symbols[1]);
    EXPECT_EQ(found_at(found, reds, found.symbols[found.marks.front().kind]) +
                  found_at(found, blues, found.symbols[1 - found.marks.front().kind]),
              16u);
}

TEST(InkedMarks, InBoxesOfPrintAreNone) {
    Painting painting;
    const std::vector<Point> squares = scattered({30, 40}, 8), letters = scattered({40, 150}, 6);
    for (const Point at : squares) painting.paint(square(at, 6));
    for (const Point at : letters) painting.paint(triangle(at, 7));
    std::vector<Box> print;
    for (const Point at : letters) print.push_back({at.x - 8, at.y - 8, at.x + 8, at.y + 8});
    print.push_back({squares[0].x - 8, squares[0].y - 8, squares[0].x + 8, squares[0].y + 8});  // by mistake
    const InkedMarks found = without_print(painting.marks(), print);
    EXPECT_EQ(found.marks.size(), squares.size());
    EXPECT_EQ(found_at(found, squares, PlotSymbol::square), squares.size());
    Image picture = painting.picture;
    take_out(picture, found);
    for (const Point at : letters) EXPECT_EQ(picture.row(static_cast<int>(at.y))[3 * static_cast<int>(at.x)], 0) << "it stays";
}

TEST(InkedMarks, ThatLieOverEachOtherAreTwo) {
    Painting painting;
    std::vector<Point> places = scattered({30, 60}, 5);
    places.insert(places.end(), {{250, 220}, {257, 224}, {60, 220}, {60, 231}});
    for (const Point at : places) painting.paint(square(at, 6));
    const InkedMarks found = painting.marks();
    EXPECT_EQ(found.marks.size(), places.size());
    EXPECT_EQ(found_at(found, places, PlotSymbol::square), places.size());
    Image picture = painting.picture;
    take_out(picture, found);
    EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.end(), [](std::uint8_t level) { return level > 200; }));
}

TEST(InkedMarks, OnALineAreTakenOutAndTheLineGoesOn) {
    for (const Form form : {Form{square}, Form{triangle}, Form{open_square}, Form{cross}}) {
        Painting painting;
        const std::vector<Point> places = scattered({40, 80}, 9);
        for (std::size_t i = 0; i + 1 < places.size(); ++i) painting.paint(line(places[i], places[i + 1], 2));
        for (const Point at : places) painting.paint(form(at, 8));
        const InkedMarks found = painting.marks();
        ASSERT_EQ(found.symbols.size(), 1u);
        // Of those made of lines some are not told from the lines that meet there.
        const bool filled = form == Form{square} || form == Form{triangle};
        EXPECT_GE(found_at(found, places, found.symbols[0]), filled ? places.size() : 6u);
        Image picture = painting.picture;
        take_out(picture, found);
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
            for (double t = 0.02; t < 1; t += 0.02) {
                const double x = places[i].x + t * (places[i + 1].x - places[i].x),
                             y = places[i].y + t * (places[i + 1].y - places[i].y);
                int darkest = 255;
                for (int v = -2; v <= 2; ++v)
                    for (int u = -2; u <= 2; ++u)
                        darkest = std::min<int>(darkest, picture.row(static_cast<int>(y) + v)[3 * (static_cast<int>(x) + u)]);
                EXPECT_LT(darkest, 160) << i << ' ' << t;
            }
    }
}

TEST(InkedMarks, HeadsTicksAndLettersAreNone) {
    Painting heads;
    for (const Point at : scattered({30, 60}, 9)) {
        heads.paint(line({at.x, at.y}, {at.x, at.y + 60}, 2));
        heads.paint(triangle(at, 6));
    }
    EXPECT_TRUE(heads.marks().marks.empty());
    Painting ticks;
    ticks.paint(line({10, 150}, {390, 150}, 2));
    for (int i = 0; i < 11; ++i) ticks.paint(line({30 + 33.0 * i, 140}, {30 + 33.0 * i, 160}, 2));
    EXPECT_TRUE(ticks.marks().marks.empty());
    Painting axes;
    axes.paint(line({30, 250}, {390, 250}, 2));
    axes.paint(line({60, 30}, {60, 280}, 2));
    for (int i = 1; i < 4; ++i) {
        axes.paint(line({60 + 80.0 * i, 241}, {60 + 80.0 * i, 259}, 2));
        axes.paint(line({51, 250 - 60.0 * i}, {69, 250 - 60.0 * i}, 2));
    }
    EXPECT_TRUE(axes.marks().marks.empty()) << "six on two axes";
    // As "bo do po" would be.
    Painting print;
    for (int i = 0; i < 6; ++i) {
        print.paint(ring({40 + 50.0 * i, 100 + 9.0 * (i % 3)}, 6));
        print.paint(line({54 + 50.0 * i, 94 + 9.0 * (i % 3)}, {54 + 50.0 * i, 104.0 + 9 * (i % 3)}, 3 + i % 4));
    }
    EXPECT_TRUE(print.marks().marks.empty());
    EXPECT_TRUE(inked_marks_in(ticks.picture, ink_on_white(ticks.picture), 6, 0.4).marks.empty()) << "pixels of a hand's width";
    Painting two;
    for (const Point at : scattered({30, 60}, 2)) two.paint(square(at, 6));
    EXPECT_TRUE(two.marks().marks.empty());
}

// A pixel more here and there on a slope is no point.
TEST(InkedPoints, ALineOnASlopeHasNone) {
    for (double slope = 0.1; slope < 2; slope += 0.07)
        for (const double width : {2.6, 3.1, 3.9}) {
            Painting painting;
            painting.paint(line({20, 20}, {20 + 250 / std::max(1.0, slope), 20 + 250 * std::min(1.0, slope)}, width));
            EXPECT_TRUE(points_in(ink_on_white(painting.picture), 1, 20).empty()) << slope << ' ' << width;
        }
}

TEST(MarkForms, SymbolsAllDifferAsLongAsThereAreEnough) {
    using enum MarkForm;
    const std::vector<MarkForm> five{disc, disc, disc, disc, disc};
    const auto symbols = symbols_for(five);
    EXPECT_EQ(std::set<PlotSymbol>(symbols.begin(), symbols.end()).size(), 5u);
    EXPECT_EQ(symbols_for({ring, triangle}), (std::vector<PlotSymbol>{PlotSymbol::ring, PlotSymbol::triangle}));
    EXPECT_EQ(symbols_for({disc, disc, disc, disc, disc, disc}), std::vector<PlotSymbol>(6, PlotSymbol::disc));
}

TEST(SymbolArea, ReachesAsFarAsTheSymbolAndIsHollowIfThatIs) {
    for (const PlotSymbol symbol :
         {PlotSymbol::disc, PlotSymbol::ring, PlotSymbol::square, PlotSymbol::triangle, PlotSymbol::cross}) {
        const Area area = symbol_area(symbol, {50, 50}, 2.5);
        double farthest = 0;
        for (const Point& p : area.rings[0]) farthest = std::max(farthest, distance(p, {50, 50}));
        EXPECT_NEAR(farthest, reach_of(symbol, 2.5), 0.1);
        EXPECT_EQ(area.rings.size(), symbol == PlotSymbol::ring || symbol == PlotSymbol::square ? 2u : 1u);
        EXPECT_EQ(area.role, Role::symbol);
    }
}

}  // namespace
}  // namespace tactics::inked_marks_test
