// SPDX-License-Identifier: Apache-2.0
// Heads of arrows, filled points and dashed lines of a drawn picture.
#include "filters/known_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "filters/arrow_heads.h"
#include "filters/dash_rows.h"
#include "filters/inked_legend.h"
#include "filters/inked_points.h"
#include "tests/filters/pictures.h"

namespace tactics::known_parts_test {
namespace {

using Shape = std::function<bool(double, double)>;

// Black where any of them is, with soft borders: each pixel is looked at in sixteen places.
Image inked(int width, int height, const std::vector<Shape>& shapes) {
    return pictures::drawn(width, height, [&](int x, int y) {
        int black = 0;
        for (int i = 0; i < 16; ++i) {
            const double u = x + (i % 4 + 0.5) / 4, v = y + (i / 4 + 0.5) / 4;
            black += std::any_of(shapes.begin(), shapes.end(), [&](const Shape& shape) { return shape(u, v); }) ? 1 : 0;
        }
        return 255 - 255 * black / 16;
    });
}

Shape line(Point a, Point b, double width) {
    return [=](double x, double y) {
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double t = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        return std::hypot(x - a.x - t * dx, y - a.y - t * dy) <= width / 2;
    };
}

Shape disc(Point middle, double radius) {
    return [=](double x, double y) { return std::hypot(x - middle.x, y - middle.y) <= radius; };
}

Shape polygon(std::vector<Point> ring) {
    return [ring = std::move(ring)](double x, double y) {
        bool inside = false;
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            if ((ring[i].y > y) != (ring[j].y > y) &&
                x < ring[i].x + (ring[j].x - ring[i].x) * (y - ring[i].y) / (ring[j].y - ring[i].y))
                inside = !inside;
        return inside;
    };
}

enum class Form { filled, open, notched };

struct Arrow {
    Point tip, from, barbs[2];
    std::vector<Shape> shapes;
};

Arrow arrow(Form form, double degrees, double length, double half_angle, double width) {
    const double a = degrees * std::numbers::pi / 180, h = half_angle * std::numbers::pi / 180;
    Arrow made;
    made.tip = {100 + 60 * std::cos(a), 100 + 60 * std::sin(a)};
    made.from = {100 - 60 * std::cos(a), 100 - 60 * std::sin(a)};
    for (int i = 0; i < 2; ++i) {
        const double b = a + std::numbers::pi + (i == 0 ? h : -h);
        made.barbs[i] = {made.tip.x + length * std::cos(b), made.tip.y + length * std::sin(b)};
    }
    const double back = form == Form::notched ? 0.6 * length : length * std::cos(h);
    const Point neck{made.tip.x - back * std::cos(a), made.tip.y - back * std::sin(a)};
    made.shapes.push_back(line(made.from, form == Form::open ? made.tip : neck, width));
    if (form == Form::open) {
        for (const Point& barb : made.barbs) made.shapes.push_back(line(made.tip, barb, width));
    } else {
        made.shapes.push_back(polygon({made.tip, made.barbs[0], neck, made.barbs[1]}));
    }
    return made;
}

double barb_off(const InkedHead& head, const Arrow& truth) {
    const auto off = [&](int i, int j) {
        return std::max(distance(head.barbs[0], truth.barbs[i]), distance(head.barbs[1], truth.barbs[j]));
    };
    return std::min(off(0, 1), off(1, 0));
}

TEST(ArrowHeads, AreFoundOfAnyFormSizeAndDirection) {
    int all = 0, found = 0;
    for (const Form form : {Form::filled, Form::open, Form::notched})
        for (const double length : {11.0, 18.0, 30.0})
            for (const double half : {19.0, 27.0})
                for (double degrees = 3; degrees < 360; degrees += 53, ++all) {
                    const Arrow truth = arrow(form, degrees, length, half, 2);
                    const auto heads = arrow_heads_in(inked(200, 200, truth.shapes), 60);
                    ASSERT_LE(heads.size(), 1u) << degrees;
                    found += heads.size() == 1 && distance(heads[0].tip, truth.tip) < 3 && barb_off(heads[0], truth) < 5 ? 1 : 0;
                }
    EXPECT_GE(found, 0.97 * all) << all;
}

TEST(ArrowHeads, PointAtBoxesAndStandAtBothEnds) {
    Arrow one = arrow(Form::filled, 0, 16, 22, 2);
    one.shapes.push_back(line({one.tip.x + 1, 60}, {one.tip.x + 1, 140}, 2));
    const auto heads = arrow_heads_in(inked(200, 200, one.shapes), 60);
    ASSERT_EQ(heads.size(), 1u);
    EXPECT_LT(distance(heads[0].tip, one.tip), 3);
    Arrow both = arrow(Form::open, 30, 16, 25, 2);
    for (const Shape& shape : arrow(Form::open, 210, 16, 25, 2).shapes) both.shapes.push_back(shape);
    EXPECT_EQ(arrow_heads_in(inked(200, 200, both.shapes), 60).size(), 2u);
}

TEST(ArrowHeads, CrossingsBranchesCornersTicksAndCurvesHaveNone) {
    const std::vector<std::vector<Shape>> pictures{
        {line({20, 20}, {180, 180}, 2), line({20, 180}, {180, 20}, 2), line({20, 100}, {180, 100}, 2)},
        {line({20, 20}, {180, 20}, 2), line({20, 20}, {20, 180}, 2), line({20, 60}, {28, 60}, 2), line({20, 100}, {28, 100}, 2)},
        {line({100, 20}, {100, 100}, 2), line({100, 100}, {50, 180}, 2), line({100, 100}, {150, 180}, 2)},
        {line({20, 100}, {180, 100}, 2), line({180, 92}, {180, 108}, 2)},
        {disc({60, 100}, 30), line({60, 100}, {180, 100}, 2)},
        {line({20, 100}, {180, 100}, 5)},
        {polygon({{20, 20}, {180, 20}, {100, 160}})},
    };
    for (std::size_t i = 0; i < pictures.size(); ++i) EXPECT_EQ(arrow_heads_in(inked(200, 200, pictures[i]), 60).size(), 0u) << i;
    EXPECT_TRUE(arrow_heads_in(make_image(3, 3, 1, 0.2, 0), 60).empty());
}

TEST(ArrowHeads, TakenOutLeaveTheirLineUpToTheTip) {
    for (const Form form : {Form::filled, Form::open}) {
        const Arrow truth = arrow(form, 40, 20, 25, 2);
        Image picture = inked(200, 200, truth.shapes);
        take_out(picture, arrow_heads_in(picture, 60));
        const auto dark = [&](Point p) { return picture.row(static_cast<int>(p.y))[static_cast<int>(p.x)] < 128; };
        for (const Point& barb : truth.barbs)
            for (const double t : {0.5, 0.75, 0.95})
                EXPECT_FALSE(dark({truth.tip.x + t * (barb.x - truth.tip.x), truth.tip.y + t * (barb.y - truth.tip.y)}));
        for (double t = 0.02; t < 1; t += 0.02)
            EXPECT_TRUE(dark({truth.tip.x + t * (truth.from.x - truth.tip.x), truth.tip.y + t * (truth.from.y - truth.tip.y)}))
                << t;
    }
}

TEST(InkedPoints, AreDiscsAloneAndOnLinesButNoCrossingsEndsOrHeads) {
    const Image discs = inked(200, 200,
                              {disc({40, 40}, 4), disc({100, 100}, 7), line({20, 100}, {180, 100}, 2),
                               line({150, 20}, {150, 60}, 2), disc({150, 40}, 5), disc({60, 160}, 3)});
    const auto points = points_in(discs, 1, 20);
    ASSERT_EQ(points.size(), 4u);
    for (const auto& [middle, radius, arms] : {std::tuple{Point{40, 40}, 4.0, 0u}, std::tuple{Point{100, 100}, 7.0, 2u},
                                               std::tuple{Point{150, 40}, 5.0, 2u}, std::tuple{Point{60, 160}, 3.0, 0u}})
        EXPECT_TRUE(std::any_of(points.begin(), points.end(), [at = middle, r = radius, n = arms](const InkedPoint& point) {
            return distance(point.middle, at) < 1 && std::abs(point.radius - r) < 1 && point.arms.size() == n;
        })) << middle.x;
    const Image others = inked(200, 200,
                               {line({20, 20}, {180, 180}, 5), line({20, 180}, {180, 20}, 5), line({20, 100}, {60, 100}, 5),
                                polygon({{120, 20}, {150, 20}, {135, 60}}), disc({150, 120}, 30)});
    EXPECT_TRUE(points_in(others, 1, 20).empty());
    Image picture = discs;
    take_out(picture, points);
    EXPECT_LT(picture.row(100)[100], 128);  // the line goes on
    EXPECT_GT(picture.row(95)[100], 200);
    EXPECT_GT(picture.row(40)[40], 200);
}

TEST(KnownParts, ADashedCurveIsOneLineOfItsWholeLengthAndIsTakenOut) {
    std::vector<Shape> dashes;
    const auto at = [](double t) { return Point{20 + t, 100 + 40 * std::sin(t / 50)}; };
    for (double t = 0; t < 340; t += 16) dashes.push_back(line(at(t), at(t + 9), 2));
    Image picture = inked(400, 200, dashes);
    const KnownParts parts = take_known_parts(picture);
    ASSERT_EQ(parts.strokes.size(), 1u);
    EXPECT_EQ(parts.strokes[0].role, Role::dash);
    EXPECT_NEAR(std::abs(parts.strokes[0].points.front().x - parts.strokes[0].points.back().x), 345 * pictures::kPixel, 1);
    EXPECT_EQ(std::count_if(picture.pixels.begin(), picture.pixels.end(), [](std::uint8_t p) { return p < 200; }), 0);
}

TEST(KnownParts, HeadsAreOpenAndLargeEnoughForAFinger) {
    Image picture = inked(200, 200, arrow(Form::filled, 10, 14, 20, 2).shapes);
    const KnownParts parts = take_known_parts(picture);
    ASSERT_EQ(parts.strokes.size(), 1u);
    const Stroke& head = parts.strokes[0];
    EXPECT_EQ(head.role, Role::arrow);
    EXPECT_FALSE(head.closed);
    ASSERT_EQ(head.points.size(), 3u);
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) EXPECT_GE(distance(head.points[1], head.points[i]), 6.3);
}

// Two curves and, at the top left, a sample of each before words that are painted over.
TEST(InkedLegend, WordsGoToTheCurveInTheColourOfTheirSample) {
    Image picture = make_image(400, 300, 3, 0, 255);
    const auto paint = [&](int x, int y, std::array<std::uint8_t, 3> colour) {
        for (int v = y - 1; v <= y + 1; ++v) std::copy(colour.begin(), colour.end(), picture.row(v) + 3 * x);
    };
    const std::array<std::uint8_t, 3> red{220, 30, 30}, blue{30, 60, 220}, black{0, 0, 0};
    for (int x = 20; x < 380; ++x) {
        paint(x, 250 - x / 4, red);
        paint(x, 120 + x / 4, blue);
        paint(x, 290, black);
    }
    for (int x = 30; x < 60; ++x) {
        paint(x, 20, blue);
        paint(x, 40, red);
        paint(x, 60, black);
    }
    const std::vector<LegendWords> words{
        {{66, 14, 120, 26}, 12}, {{66, 34, 120, 46}, 12}, {{66, 54, 120, 66}, 12}, {{200, 270, 240, 282}, 12}};
    const auto entries = legend_in(picture, words);
    ASSERT_EQ(entries.size(), 2u);  // black may be an axis
    for (const LegendEntry& entry : entries) {
        const double on = entry.words == 0 ? 120 + entry.at.x / 4 : 250 - entry.at.x / 4;
        EXPECT_NEAR(entry.at.y, on, 3);
        EXPECT_GT(std::abs((120 + entry.at.x / 4) - (250 - entry.at.x / 4)), 40);  // not where they cross
        EXPECT_NEAR(entry.sample.left, 30, 2);
    }
    EXPECT_TRUE(legend_in(picture, {words[0]}).empty());
}

TEST(InkedLegend, SamplesOfOneColourSayNothing) {
    Image picture = make_image(400, 300, 1, 0, 255);
    for (const int y : {20, 40, 150, 200})
        for (int x = y < 100 ? 30 : 20; x < (y < 100 ? 60 : 380); ++x) picture.row(y)[x] = picture.row(y + 1)[x] = 90;
    EXPECT_TRUE(legend_in(picture, {{{66, 14, 120, 26}, 12}, {{66, 34, 120, 46}, 12}}).empty());
}

// Marks of these lengths, and gaps, along a wave around that height; as a plotting tool draws them.
Shape wave(double height, const std::vector<double>& marks) {
    double period = 0;
    for (const double mark : marks) period += mark;
    return [=](double x, double y) {
        if (x < 20 || x > 380) return false;
        const double slope = 12 * std::cos(x / 40) / 40, off = std::abs(y - height - 12 * std::sin(x / 40));
        if (off > 1 * std::hypot(1, slope)) return false;
        double along = std::fmod(x - 20, period);
        for (std::size_t i = 0; i < marks.size(); along -= marks[i++])
            if (along < marks[i]) return i % 2 == 0;
        return false;
    };
}

const std::vector<double> kDashed{11, 4}, kDotted{2, 4}, kDashDotted{16, 4, 2, 4};

TEST(DashRows, MarksOfEachKindAreToldApart) {
    for (const auto& [marks, kind] : {std::pair{kDashed, DashKind::dashes}, std::pair{kDotted, DashKind::dots},
                                      std::pair{kDashDotted, DashKind::dashes_and_dots}}) {
        const Image picture = inked(400, 100, {wave(50, marks)});
        const auto rows = dash_rows_in(picture, picture, {30, 5, 12});
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0].kind, kind);
        EXPECT_LT(std::min(rows[0].points.front().x, rows[0].points.back().x), 30);
        EXPECT_GT(std::max(rows[0].points.front().x, rows[0].points.back().x), 370);
    }
}

TEST(DashRows, GoOnBehindWhatTheyCross) {
    std::vector<Shape> shapes{line({200, 20}, {200, 280}, 2)};
    for (double t = 0; t < 300; t += 14)
        for (const double sign : {1.0, -1.0}) {
            const auto on = [&](double u) { return Point{50 + u, 150 + sign * 0.6 * (u - 150)}; };
            shapes.push_back(line(on(t), on(t + 8), 2));
        }
    const Image picture = inked(400, 300, shapes);
    const auto rows = dash_rows_in(picture, picture, {30, 5, 10});
    ASSERT_EQ(rows.size(), 2u);
    for (const DashRow& row : rows) EXPECT_GT(distance(row.points.front(), row.points.back()), 320);
}

// As the dashes beside a mark are cut off and what is under it is not seen.
TEST(DashRows, GoOnBehindMarksWithTheirOwnDashes) {
    for (const DashKind kind : {DashKind::dashes, DashKind::dots}) {
        const auto marks = kind == DashKind::dashes ? kDashed : kDotted;
        std::vector<HidingMark> hiding;
        for (const double x : {60.0, 140.0, 220.0, 300.0}) hiding.push_back({{x, 50}, 8});
        const Image picture = [&] {
            Image image = inked(360, 100, {wave(50, marks)});
            for (HidingMark& mark : hiding) {
                // The line's own place there.
                double sum = 0, n = 0;
                for (int x = static_cast<int>(mark.middle.x) - 12; x < static_cast<int>(mark.middle.x) + 12; ++x)
                    for (int y = 0; y < 100; ++y)
                        if (image.row(y)[x] < 128) sum += y + 0.5, ++n;
                mark.middle.y = sum / n;
                for (int y = 0; y < 100; ++y)
                    for (int x = 0; x < 360; ++x)
                        if (distance({x + 0.5, y + 0.5}, mark.middle) < mark.radius + 2) image.row(y)[x] = 255;
            }
            return image;
        }();
        const auto rows = dash_rows_in(picture, picture, {30, 5, 8}, hiding);
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0].kind, kind);
        EXPECT_GT(std::abs(rows[0].points.front().x - rows[0].points.back().x), 300);
    }
}

TEST(DashRows, GetStylesThatAFingerTellsApartIfAPictureHasSeveral) {
    Image picture = inked(400, 200, {wave(50, kDashed), wave(100, kDotted), wave(150, kDashDotted)});
    picture.mm_per_pixel = 0.4;
    std::set<std::pair<Role, LineClass>> styles;
    for (const Stroke& stroke : take_known_parts(picture).strokes) styles.insert({stroke.role, stroke.line});
    const std::set<std::pair<Role, LineClass>> all{
        {Role::dash, LineClass::normal}, {Role::dots, LineClass::thick}, {Role::dash, LineClass::thick}};
    EXPECT_EQ(styles, all);
    Image one = inked(400, 100, {wave(50, kDotted)});
    one.mm_per_pixel = 0.4;
    const KnownParts parts = take_known_parts(one);
    ASSERT_EQ(parts.strokes.size(), 1u);
    EXPECT_EQ(parts.strokes[0].role, Role::dash);
}

TEST(InkedLegend, BlackLinesAreToldByTheirDashes) {
    const std::vector<std::vector<double>> looks{{400}, kDashed, kDotted, kDashDotted};
    std::vector<Shape> shapes;
    std::vector<LegendWords> words;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const double y = 20 + 20 * static_cast<double>(i);
        shapes.push_back(wave(140 + 50 * static_cast<double>(i), looks[i]));
        shapes.push_back([look = wave(y, looks[i]), y](double u, double v) {  // begins with a mark, as legends do
            return u < 75 && std::abs(v - y) <= 1 && look(u - 10, y + 12 * std::sin((u - 10) / 40));
        });
        const int top = static_cast<int>(y) - 6;
        words.push_back({{84, top, 136, top + 12}, 12});
    }
    const auto entries = legend_in(inked(400, 340, shapes), words);
    ASSERT_EQ(entries.size(), 4u);
    for (const LegendEntry& entry : entries)
        EXPECT_NEAR(entry.at.y, 140 + 50 * static_cast<double>(entry.words) + 12 * std::sin(entry.at.x / 40), 3);
}

// One that is whole, too, and in colour, does not take the words of the black one, and does not end it where they cross.
TEST(InkedLegend, ABlackLineIsToldFromOnesInColour) {
    const auto one = [](double height, double slope) {
        return [=](double x, double y) { return x > 20 && x < 380 && std::abs(y - height - slope * x) <= 1.5; };
    };
    const auto sample = [](double height) {
        return [=](double x, double y) { return x > 30 && x < 75 && std::abs(y - height) <= 1.5; };
    };
    const Image black = inked(400, 340, {one(180, 0.2), sample(20)}), red = inked(400, 340, {one(290, -0.35), sample(40)}),
                dashed = inked(400, 340, {wave(120, kDashed), [](double x, double y) {
                                              return x > 30 && x < 72 && std::abs(y - 60) <= 1 && std::fmod(x - 30, 15) < 11;
                                          }});
    Image picture = make_image(400, 340, 3, 0, 255);
    for (int y = 0; y < 340; ++y)
        for (int x = 0; x < 400; ++x) {
            const int off_red = 255 - red.row(y)[x], dark = std::min(black.row(y)[x], dashed.row(y)[x]);
            const std::array<int, 3> colour{255 - off_red * 35 / 255, 255 - off_red * 225 / 255, 255 - off_red * 225 / 255};
            for (std::size_t c = 0; c < 3; ++c)  // the red one is drawn over the black one
                picture.row(y)[3 * x + static_cast<int>(c)] =
                    static_cast<std::uint8_t>(off_red > 0 ? colour[c] : std::min(dark, colour[c]));
        }
    const auto entries = legend_in(picture, {{{84, 14, 136, 26}, 12}, {{84, 34, 136, 46}, 12}, {{84, 54, 136, 66}, 12}});
    ASSERT_EQ(entries.size(), 3u);
    for (const LegendEntry& entry : entries) {
        const double on[] = {180 + 0.2 * entry.at.x, 290 - 0.35 * entry.at.x, 120 + 12 * std::sin(entry.at.x / 40)};
        EXPECT_NEAR(entry.at.y, on[entry.words], 3) << entry.words;
    }
}

// A curve in colour that covers the black one for a while leaves two pieces of it, one beside the other; two curves, one above
// the other, are no pieces.
TEST(InkedLegend, ABlackLineThatIsCoveredForAWhileIsOne) {
    const auto entries_with = [](bool second) {
        const auto is_black = [second](double x, double y) {
            return x > 20 && x < 380 && (std::abs(y - 180) <= 1.5 || (second && std::abs(y - 230 - 0.2 * x) <= 1.5));
        };
        const auto sloped = [](double x) { return 0.1 * x; };
        const Image black = inked(400, 340,
                                  {[&](double x, double y) { return is_black(x, y - sloped(x)); },
                                   [](double x, double y) { return x > 30 && x < 75 && std::abs(y - 20) <= 1.5; }}),
                    red = inked(400, 340,
                                {[&](double x, double y) { return x > 150 && x < 250 && std::abs(y - 180 - sloped(x)) <= 3; }}),
                    dashed = inked(400, 340, {wave(120, kDashed), [](double x, double y) {
                                                  return x > 30 && x < 72 && std::abs(y - 60) <= 1 && std::fmod(x - 30, 15) < 11;
                                              }});
        Image picture = make_image(400, 340, 3, 0, 255);
        for (int y = 0; y < 340; ++y)
            for (int x = 0; x < 400; ++x)
                for (int c = 0; c < 3; ++c)
                    picture.row(y)[3 * x + c] =
                        red.row(y)[x] < 128 ? (c == 0 ? 220 : 30) : std::min(black.row(y)[x], dashed.row(y)[x]);
        return legend_in(picture, {{{84, 14, 136, 26}, 12}, {{84, 54, 136, 66}, 12}});
    };
    const auto one = entries_with(false);
    ASSERT_EQ(one.size(), 2u);
    EXPECT_EQ(one.front().words, 0u);
    EXPECT_NEAR(one.front().at.y, 180 + 0.1 * one.front().at.x, 3);
    EXPECT_EQ(entries_with(true).size(), 1u);
}

}  // namespace
}  // namespace tactics::known_parts_test
