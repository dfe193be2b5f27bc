// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "tests/filters/shapes.h"

namespace tactics::trace_test {
namespace {

using shapes::bar;
using shapes::blank;
using shapes::drawn;
using shapes::ring;

constexpr double kPi = std::numbers::pi;
// The sizes below are in pixels: a pixel is a millimetre.
constexpr std::string_view kTrace = "trace";

double rms_from_circle(const Stroke& stroke, Point centre, double radius) {
    double sum = 0;
    const auto points = shapes::walk(stroke, 0.5);
    for (const Point& p : points) sum += std::pow(std::hypot(p.x - centre.x, p.y - centre.y) - radius, 2);
    return std::sqrt(sum / static_cast<double>(points.size()));
}

// The strength that a blurred disc's edge has, as an edge detector would give it: a ridge of Gaussian shape.
EdgeMap disc_edges(int size, Point centre, double radius, bool thinned) {
    EdgeMap edges{size, size, 1, thinned, {}, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double d = std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y) - radius;
            const bool kept = thinned ? std::abs(d) <= 0.5 : std::abs(d) < 5;
            edges.strength.push_back(kept ? static_cast<float>(100 * std::exp(-d * d / 4)) : 0.0f);
            double angle = std::atan2(y + 0.5 - centre.y, x + 0.5 - centre.x);
            if (angle < 0) angle += kPi;
            edges.normal.push_back(static_cast<float>(std::min(angle, 3.14159)));
        }
    return edges;
}

TEST(Trace, FindsTheOutlineOfADisc) {
    for (const double radius : {8.0, 21.3, 50.0, 90.0}) {
        for (const Point centre : {Point{100, 100}, Point{100.3, 99.6}}) {
            EdgeMap edges = disc_edges(200, centre, radius, true);
            auto drawing = drawn(kTrace, edges);
            ASSERT_EQ(drawing.strokes.size(), 1u) << radius;
            EXPECT_TRUE(drawing.strokes[0].closed);
            EXPECT_LT(rms_from_circle(drawing.strokes[0], centre, radius), radius < 10 ? 0.3 : 0.15) << radius;

            edges = disc_edges(200, centre, radius, false);
            for (int with_normal = 1; with_normal >= 0; --with_normal) {
                drawing = drawn(kTrace, edges);
                ASSERT_EQ(drawing.strokes.size(), 1u) << radius;
                EXPECT_TRUE(drawing.strokes[0].closed);
                EXPECT_LT(rms_from_circle(drawing.strokes[0], centre, radius), radius < 10 ? 0.15 : 0.1) << radius;
                EXPECT_GT(drawing.strokes[0].strength, 93);
                edges.normal.clear();
            }
        }
    }
}

TEST(Trace, MakesOneStraightStrokeOfABar) {
    for (const double width : {1.5, 3.0, 8.0})
        for (int degrees = 0; degrees < 180; degrees += 3) {
            SCOPED_TRACE(testing::Message() << width << " wide, " << degrees << " degrees");
            Image image = blank(200, 200);
            const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
            const Point a{100.2 - 80 * c, 99.7 - 80 * s}, b{100.2 + 80 * c, 99.7 + 80 * s};
            bar(image, a, b, width);
            const auto drawing = drawn(kTrace, image);
            ASSERT_EQ(drawing.strokes.size(), 1u);
            const Stroke& stroke = drawing.strokes[0];
            EXPECT_FALSE(stroke.closed);
            EXPECT_EQ(stroke.strength, 0);
            EXPECT_NEAR(length_of(stroke), 160, width + 1);
            // In place: on ink of whole pixels the middle of a slanted line is up to half a diagonal off. Straight: off by
            // the same all along.
            double mean = 0, count = 0;
            const auto off = [&](Point at) { return (at.x - a.x) * s - (at.y - a.y) * c; };
            const auto is_inner = [&](Point at) {
                return std::min(std::hypot(at.x - a.x, at.y - a.y), std::hypot(at.x - b.x, at.y - b.y)) > width + 2;
            };
            for (const Point& at : stroke.points) {
                EXPECT_LT(std::abs(off(at)), 0.7);
                if (is_inner(at)) mean += off(at), ++count;
            }
            for (const Point& at : stroke.points) {
                EXPECT_TRUE(!is_inner(at) || std::abs(off(at) - mean / count) < 0.2) << off(at) - mean / count;
            }
        }
}

struct Figure {
    std::string_view name;
    void (*draw)(Image& image, double width);
    std::size_t open;
    std::size_t closed;
};

Point eight(int k) { return {100 + 80 * std::sin(k * kPi / 100), 100 + 50 * std::sin(k * kPi / 50)}; }

const Figure kFigures[] = {
    {"T",
     [](Image& i, double w) {
         bar(i, {20, 40}, {180, 40}, w), bar(i, {100, 40}, {100, 180}, w);
     },
     2, 0},
    {"X",
     [](Image& i, double w) {
         bar(i, {20, 30}, {180, 170}, w), bar(i, {30, 170}, {170, 30}, w);
     },
     2, 0},
    {"flat X",
     [](Image& i, double w) {
         bar(i, {20, 70}, {180, 130}, w), bar(i, {20, 130}, {180, 70}, w);
     },
     2, 0},
    {"Y",
     [](Image& i, double w) {
         bar(i, {100, 100}, {100, 180}, w), bar(i, {100, 100}, {31, 60}, w), bar(i, {100, 100}, {169, 60}, w);
     },
     3, 0},
    {"plus",
     [](Image& i, double w) {
         bar(i, {20, 100}, {180, 100}, w), bar(i, {100, 20}, {100, 180}, w);
     },
     2, 0},
    {"theta",
     [](Image& i, double w) {
         ring(i, {100, 100}, 70, w), bar(i, {30, 100}, {170, 100}, w);
     },
     1, 1},
    {"eight",
     [](Image& i, double w) {
         for (int k = 0; k < 200; ++k) bar(i, eight(k), eight(k + 1), w);
     },
     0, 1},
    {"ring",
     [](Image& i, double w) {
         ring(i, {100, 100}, 70, w);
     },
     0, 1},
    {"square",
     [](Image& i, double w) {
         bar(i, {40, 40}, {160, 40}, w), bar(i, {160, 40}, {160, 160}, w), bar(i, {160, 160}, {40, 160}, w),
             bar(i, {40, 160}, {40, 40}, w);
     },
     0, 1},
    {"grid",
     [](Image& i, double w) {
         for (int k = 0; k < 5; ++k)
             bar(i, {14, 30 + 35.0 * k}, {186, 30 + 35.0 * k}, w), bar(i, {30 + 35.0 * k, 14}, {30 + 35.0 * k, 186}, w);
     },
     10, 0},
    {"star",
     [](Image& i, double w) {
         for (int k = 0; k < 4; ++k)
             bar(i, {100 + 80 * std::cos(k * kPi / 4), 100 + 80 * std::sin(k * kPi / 4)},
                 {100 - 80 * std::cos(k * kPi / 4), 100 - 80 * std::sin(k * kPi / 4)}, w);
     },
     4, 0},
};

TEST(Trace, MakesTheLinesThatAHandWouldDraw) {
    for (const Figure& figure : kFigures)
        for (const double width : {1.5, 4.0, 7.0}) {
            SCOPED_TRACE(testing::Message() << figure.name << ", " << width << " wide");
            Image image = blank(200, 200);
            figure.draw(image, width);
            const auto drawing = drawn(kTrace, image);
            std::size_t closed = 0;
            for (const Stroke& stroke : drawing.strokes) closed += stroke.closed ? 1 : 0;
            EXPECT_EQ(closed, figure.closed);
            EXPECT_EQ(drawing.strokes.size() - closed, figure.open);
            // All ink lies along the lines, and all lines lie on ink.
            for (int y = 0; y < 200; ++y)
                for (int x = 0; x < 200; ++x) {
                    if (image.row(y)[x] != 0) continue;
                    double least = 1e9;
                    for (const Stroke& stroke : drawing.strokes)
                        least = std::min(least, shapes::to_stroke({x + 0.5, y + 0.5}, stroke));
                    ASSERT_LT(least, width * 0.75 + 1.5) << x << " " << y;
                }
            for (const Stroke& stroke : drawing.strokes)
                for (const Point& p : stroke.points) {
                    double darkest = 255;
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx)
                            darkest =
                                std::min<double>(darkest, image.row(static_cast<int>(p.y) + dy)[static_cast<int>(p.x) + dx]);
                    EXPECT_EQ(darkest, 0) << p.x << " " << p.y;
                }
        }
}

TEST(Trace, LinesThatMeetStillTouch) {
    Image image = blank(200, 200);
    bar(image, {20, 40}, {180, 60}, 4);
    bar(image, {90, 50}, {120, 180}, 4);
    const auto drawing = drawn(kTrace, image);
    ASSERT_EQ(drawing.strokes.size(), 2u);
    const bool first_is_bar = length_of(drawing.strokes[0]) > length_of(drawing.strokes[1]);
    const Stroke &across = drawing.strokes[first_is_bar ? 0 : 1], &stem = drawing.strokes[first_is_bar ? 1 : 0];
    EXPECT_LT(std::min(shapes::to_stroke(stem.points.front(), across), shapes::to_stroke(stem.points.back(), across)), 1.0);
}

TEST(Trace, KeepsCorners) {
    Image image = blank(200, 200);
    const Point corners[] = {{40.5, 30.5}, {170.5, 60.5}, {120.5, 170.5}};
    for (int i = 0; i < 3; ++i) bar(image, corners[i], corners[(i + 1) % 3], 1.6);
    for (const std::string_view steps : {"trace", "trace\nsimplify tolerance=0.3"}) {
        const auto drawing = drawn(steps, image);
        ASSERT_EQ(drawing.strokes.size(), 1u);
        for (const Point& corner : corners) EXPECT_LT(shapes::to_stroke(corner, drawing.strokes[0]), 0.6);
    }
    EXPECT_LE(drawn("trace\nsimplify tolerance=0.5", image).strokes[0].points.size(), 6u);
}

TEST(Trace, BridgesGapsBetweenEndsThatPointAtEachOther) {
    Image image = blank(200, 60);
    bar(image, {10, 20.5}, {90, 24.5}, 1.5);
    bar(image, {98, 25}, {190, 29.5}, 1.5);
    EXPECT_EQ(drawn("trace bridge=0", image).strokes.size(), 2u);
    EXPECT_EQ(drawn("trace bridge=6", image).strokes.size(), 2u);
    EXPECT_EQ(drawn("trace bridge=10", image).strokes.size(), 1u);
    // Side by side, they do not point at each other.
    Image beside = blank(200, 60);
    bar(beside, {10, 20.5}, {90, 20.5}, 1.5);
    bar(beside, {92, 27.5}, {190, 27.5}, 1.5);
    EXPECT_EQ(drawn("trace bridge=10", beside).strokes.size(), 2u);
    // A ring with a gap closes.
    Image open = blank(200, 200);
    shapes::fill(open, [](Point p) {
        return std::abs(std::hypot(p.x - 100, p.y - 100) - 60) < 0.8 && (p.x > 100 || std::abs(p.y - 100) > 3);
    });
    EXPECT_FALSE(drawn("trace bridge=0", open).strokes[0].closed);
    EXPECT_TRUE(drawn("trace bridge=10", open).strokes[0].closed);
}

TEST(Trace, LeadsAnEndOnToTheLineThatItPointsAt) {
    Image image = blank(200, 200);
    bar(image, {20, 40}, {180, 40}, 1.5);
    bar(image, {100, 45}, {100, 180}, 1.5);
    const auto near = [&](std::string_view steps) {
        const auto drawing = drawn(steps, image);
        EXPECT_EQ(drawing.strokes.size(), 2u);
        return std::min(shapes::to_stroke(drawing.strokes[1].points.front(), drawing.strokes[0]),
                        shapes::to_stroke(drawing.strokes[1].points.back(), drawing.strokes[0]));
    };
    EXPECT_LT(near("trace bridge=8"), 1.0);
    EXPECT_GT(near("trace bridge=2"), 3);
}

TEST(Trace, CutsSpursOffAndDropsShortLines) {
    Image image = blank(200, 60);
    bar(image, {10, 30}, {190, 30}, 1.5);
    bar(image, {60, 30}, {60, 24}, 1.5);
    bar(image, {120, 30}, {120, 10}, 1.5);
    bar(image, {20, 50}, {26, 50}, 1.5);
    EXPECT_EQ(drawn("trace spur=1 shortest=1", image).strokes.size(), 4u);
    EXPECT_EQ(drawn("trace spur=10 shortest=1", image).strokes.size(), 3u);
    EXPECT_EQ(drawn("trace spur=10 shortest=10", image).strokes.size(), 2u);
}

// Error bars: what is across their ends is shorter than spurs are.
TEST(Trace, KeepsWhatIsAcrossTheEndOfALine) {
    Image image = blank(60, 60);
    bar(image, {30.5, 10}, {30.5, 50}, 1.5);
    bar(image, {24, 10}, {37, 10}, 1.5);
    const Drawing drawing = drawn("trace spur=9 shortest=4", image);
    ASSERT_EQ(drawing.strokes.size(), 2u);
    double left = 60, right = 0;
    for (const Stroke& stroke : drawing.strokes)
        for (const Point& p : stroke.points) left = std::min(left, p.x), right = std::max(right, p.x);
    EXPECT_NEAR(left, 25, 1.5);
    EXPECT_NEAR(right, 36, 1.5);
}

TEST(Trace, KeepsShortLinesFromLineToLine) {
    Image image = blank(200, 60);
    bar(image, {10, 20}, {190, 20}, 1.5);
    bar(image, {10, 40}, {190, 40}, 1.5);
    bar(image, {60, 20}, {60, 40}, 1.5);
    bar(image, {120, 20}, {120, 32}, 1.5);
    EXPECT_EQ(drawn("trace spur=5 shortest=30", image).strokes.size(), 3u);
    EXPECT_EQ(drawn("trace spur=5 shortest=50", image).strokes.size(), 2u);
}

TEST(Trace, KeepsFilledDotsAsAreas) {
    Image image = blank(200, 100, 0.2);
    shapes::disc(image, {50, 50}, 13);
    shapes::fill(image, [](Point p) { return std::abs(p.x - 150) < 11 && std::abs(p.y - 50) < 8; });
    bar(image, {90, 20}, {110, 80}, 9);
    shapes::disc(image, {190, 90}, 3);  // 1.2 mm: too small to be felt
    const auto drawing = drawn("trace", image);
    EXPECT_EQ(drawing.strokes.size(), 1u);
    ASSERT_EQ(drawing.areas.size(), 2u);
    for (const Point& p : drawing.areas[0].rings[0]) EXPECT_NEAR(std::hypot(p.x - 10, p.y - 10), 2.6, 0.1);
    EXPECT_TRUE(shapes::inside(drawing.areas[1], {30, 10}));
    EXPECT_EQ(drawn("trace shortest=6", image).areas.size(), 0u);
    EXPECT_EQ(drawn("trace shortest=1", image).areas.size(), 3u);
}

// Turning or mirroring the picture turns or mirrors the drawing, up to the choice of pixel in lines of even width.
TEST(Trace, FollowsThePictureWhenItTurns) {
    Image image = blank(160, 120);
    ring(image, {60, 60}, 41, 3);
    bar(image, {20, 20}, {150, 90}, 3);
    bar(image, {110, 110}, {140, 15}, 3);
    Image turned = blank(120, 160), flipped = blank(160, 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            turned.row(x)[119 - y] = image.row(y)[x];
            flipped.row(y)[159 - x] = image.row(y)[x];
        }
    const auto first = drawn("trace", image), second = drawn("trace", turned), third = drawn("trace", flipped);
    ASSERT_EQ(first.strokes.size(), second.strokes.size());
    ASSERT_EQ(first.strokes.size(), third.strokes.size());
    EXPECT_NEAR(total_stroke_length(first), total_stroke_length(second), 0.02 * total_stroke_length(first));
    for (const Stroke& stroke : first.strokes)
        for (const Point& p : shapes::walk(stroke, 1)) {
            double least = 1e9, least_flipped = 1e9;
            for (const Stroke& other : second.strokes) least = std::min(least, shapes::to_stroke({120 - p.y, p.x}, other));
            for (const Stroke& other : third.strokes)
                least_flipped = std::min(least_flipped, shapes::to_stroke({160 - p.x, p.y}, other));
            EXPECT_LT(least, 1.0);
            EXPECT_LT(least_flipped, 1.0);
        }
}

TEST(Trace, WorksInMillimetres) {
    Image image = blank(200, 100, 0.25);
    bar(image, {20, 50.5}, {180, 50.5}, 3);
    const auto drawing = drawn("trace", image);
    EXPECT_DOUBLE_EQ(drawing.width, 50);
    EXPECT_DOUBLE_EQ(drawing.height, 25);
    ASSERT_EQ(drawing.strokes.size(), 1u);
    for (const Point& p : drawing.strokes[0].points) EXPECT_NEAR(p.y, 50.5 * 0.25, 0.05);
    EXPECT_NEAR(length_of(drawing.strokes[0]), 40, 1);
}

TEST(Trace, StrengthIsTheMeanAlongTheLine) {
    EdgeMap edges{100, 50, 1, true, std::vector<float>(5000, 0.0f), {}};
    for (std::size_t x = 10; x < 90; ++x) {
        edges.strength[10 * 100 + x] = x < 50 ? 20.0f : 40.0f;
        edges.strength[30 * 100 + x] = 7;
    }
    const auto drawing = drawn("trace", edges);
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_NEAR(drawing.strokes[0].strength, 30, 0.5);
    EXPECT_NEAR(drawing.strokes[1].strength, 7, 0.01);
}

TEST(Trace, TakesPicturesOfAnyKind) {
    for (const auto& [w, h] : {std::pair{1, 1}, {1, 30}, {30, 1}, {2, 2}, {3, 3}, {7, 5}, {64, 48}})
        for (const std::string_view steps :
             {"trace shortest=0 spur=0", "trace bridge=0", "trace", "trace method=areas shortest=0", "trace method=areas",
              "trace shortest=0\nsimplify\nseparate\nthicken share=50"})
            for (int kind = 0; kind < 5; ++kind) {
                Image image = blank(w, h, 0.5);
                std::mt19937 random(static_cast<std::uint32_t>(kind));
                for (int y = 0; y < h; ++y)
                    for (int x = 0; x < w; ++x)
                        image.row(y)[x] = kind == 0      ? 255
                                          : kind == 1    ? 0
                                          : kind == 2    ? ((x + y) % 2 ? 0 : 255)
                                          : kind == 3    ? (x == w / 2 && y == h / 2 ? 0 : 255)
                                          : random() % 2 ? 0
                                                         : 255;
                EdgeMap edges{w, h, 0.5, kind % 2 == 0, {}, {}};
                for (const auto pixel : image.pixels) edges.strength.push_back(pixel < 128 ? 9.0f : 0.0f);
                for (const Drawing& drawing : {drawn(steps, image), drawn(steps, edges)}) {
                    EXPECT_TRUE(kind != 0 || (drawing.strokes.empty() && drawing.areas.empty()));
                    for (const Stroke& stroke : drawing.strokes) {
                        EXPECT_GE(stroke.points.size(), stroke.closed ? 3u : 2u);
                        for (const Point& p : stroke.points)
                            EXPECT_TRUE(p.x >= -0.5 && p.y >= -0.5 && p.x <= drawing.width + 0.5 && p.y <= drawing.height + 0.5);
                    }
                    for (const Area& area : drawing.areas)
                        for (const auto& points : area.rings) EXPECT_GE(points.size(), 3u);
                }
            }
}

// The worst that can come: time and memory stay in proportion to the picture (no timing here; a quadratic step would hang).
TEST(Trace, EndsOnACheckerboard) {
    Image image = blank(1500, 1100, 0.2);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.row(y)[x] = (x + y) % 2 ? 0 : 255;
    drawn("trace shortest=0\nsimplify\nseparate", image);
    drawn("trace method=areas shortest=0\nsimplify", image);
}

}  // namespace
}  // namespace tactics::trace_test
