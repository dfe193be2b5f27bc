// SPDX-License-Identifier: Apache-2.0
// Lines in a drawing of whole outlines that bound nothing: thin things that are attached, and what is inside of a face.
#include "filters/open_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "samples/draw/scenes.h"
#include "tests/filters/pictures.h"
#include "tests/filters/weights.h"

namespace tactics::open_lines_test {
namespace {

using pictures::Chance;

// Points half a millimetre apart.
std::vector<Point> dense(const Stroke& stroke) {
    std::vector<Point> points;
    for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i) {
        const Point a = stroke.points[i], b = stroke.points[(i + 1) % stroke.points.size()];
        const int steps = std::max(1, static_cast<int>(std::ceil(2 * distance(a, b))));
        for (int k = 0; k < steps; ++k) points.push_back({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
    }
    points.push_back(stroke.closed ? stroke.points.front() : stroke.points.back());
    return points;
}

double apart(const Stroke& a, const Stroke& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Point p : dense(a))
        for (const Point q : dense(b)) least = std::min(least, distance(p, q));
    return least;
}

double apart(Point p, const Stroke& b) { return apart(Stroke{{p, p}}, b); }

Drawing square() { return {200, 100, {{{{20, 40}, {100, 40}, {100, 90}, {20, 90}}, true, LineClass::normal, 200}}, {}, {}}; }

RegionLine straight(Point from, Point to, float strength = 200) {
    RegionLine line{{}, strength, {0, 0}};
    const int steps = static_cast<int>(distance(from, to));
    for (int i = 0; i <= steps; ++i)
        line.points.push_back({from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps});
    return line;
}

// One pixel is one millimetre.
std::size_t added(const RegionLine& line, OpenLines wish = {.most = 1000}) {
    Drawing drawing = square();
    add_open_lines(drawing, std::array{line}, 1, wish);
    return drawing.strokes.size() - 1;
}

TEST(OpenLines, AreLedToWhatTheyMeet) {
    Drawing drawing = square();
    add_open_lines(drawing, std::array{straight({60, 10}, {60, 37})}, 1, {.most = 1000});
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_LE(apart(drawing.strokes[1].points.back(), drawing.strokes[0]), 1);
    EXPECT_NEAR(drawing.strokes[1].points.front().y, 10, 1);
    EXPECT_EQ(drawing.strokes[1].line, LineClass::thin);
}

TEST(OpenLines, AreLedOnByWhatGoesOnFromThem) {
    RegionLine line = straight({60, 5}, {60, 39});
    EXPECT_EQ(added(line), 1u);
    line.points.resize(line.points.size() - 12);  // too far for going straight on
    EXPECT_EQ(added(line), 0u);
    line = straight({60, 5}, {60, 39});
    line.leads = {0, 12};
    EXPECT_EQ(added(line), 1u);
}

TEST(OpenLines, AreNotDrawnUnlessTheyAreSureLongApartAndAttached) {
    EXPECT_EQ(added(straight({60, 10}, {60, 37}, 100), {.least = 140, .most = 1000}), 0u);
    EXPECT_EQ(added(straight({60, 25}, {60, 40})), 0u) << "15 mm, of which 4.4 are beside the outline";
    EXPECT_EQ(added(straight({20, 37}, {100, 37})), 0u) << "beside the outline";
    EXPECT_EQ(added(straight({140, 20}, {140, 60})), 0u) << "in the middle of nowhere";
    EXPECT_EQ(added(straight({140, 20}, {140, 60}), {.most = 1000, .attached = false}), 1u);
    EXPECT_EQ(added(straight({60, 10}, {60, 37}), {.most = 20}), 0u) << "no line left";
}

TEST(OpenLines, KeepApartFromEachOther) {
    Drawing drawing = square();
    add_open_lines(drawing, std::array{straight({60, 5}, {60, 40}), straight({63, 5}, {63, 40}), straight({66, 5}, {66, 40})}, 1,
                   {.most = 1000});
    ASSERT_EQ(drawing.strokes.size(), 3u);
    EXPECT_NEAR(drawing.strokes[1].points.front().x, 60, 1);
    EXPECT_NEAR(drawing.strokes[2].points.front().x, 66, 1);
}

using ColourAt = std::function<std::array<int, 3>(int, int)>;

Image scene(const ColourAt& colour, double grain = 4) {
    Chance chance(7);
    Image image = make_image(480, 320, 3, 0.5, 0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto c = colour(x, y);
            const int noise = static_cast<int>(grain * chance.normal());
            for (std::size_t k = 0; k < 3; ++k)
                image.row(y)[3 * x + static_cast<int>(k)] = static_cast<std::uint8_t>(std::clamp(c[k] + noise, 0, 255));
        }
    return image;
}

RegionTree tree_of(const Image& image, const std::string& map) {
    return std::get<RegionTree>(pictures::filtered("nest map=" + map, image));
}

// A window in a house before the sky: the house is a thing, the window within it.
TEST(Outlines, BordersWithinAThingAreThin) {
    SKIP_WITHOUT_WEIGHTS();
    const auto within = [](int x, int y, int left, int top, int right, int bottom) {
        return x > left && x < right && y > top && y < bottom;
    };
    const Image picture = scene([&](int x, int y) -> std::array<int, 3> {
        if (within(x, y, 200, 120, 280, 180)) return {30, 40, 60};
        return within(x, y, 120, 60, 360, 260) ? std::array<int, 3>{210, 190, 150} : std::array<int, 3>{90, 150, 70};
    });
    const auto drawing = std::get<Drawing>(pictures::filtered("outlines", tree_of(picture, "learned")));
    ASSERT_EQ(drawing.strokes.size(), 2u);
    const bool first = length_of(drawing.strokes[0]) < length_of(drawing.strokes[1]);
    EXPECT_EQ(drawing.strokes[first ? 0 : 1].line, LineClass::thin);
    EXPECT_EQ(drawing.strokes[first ? 1 : 0].line, LineClass::normal);
}

class ThinThingsBy : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (GetParam() == std::string("learned")) SKIP_WITHOUT_WEIGHTS();
    }
};

// A dark hull before a light sky; a white mast of 3 pixels on it bounds nothing. Without training a map has two faint edges for
// it.
TEST(Outlines, AMastOnAHullIsALineAttachedToIt) {
    SKIP_WITHOUT_WEIGHTS();
    const auto hull = [](int x, int y) { return y > 200 && y < 270 && x > 100 + (y - 200) / 2 && x < 380 - (y - 200) / 2; };
    for (const bool mast : {true, false}) {
        const Image picture = scene([&](int x, int y) -> std::array<int, 3> {
            if (hull(x, y)) return {110, 30, 30};
            if (mast && std::abs(x - 230) <= 1 && y > 50 && y <= 200) return {250, 250, 245};
            return {110, 160, 210};
        });
        const auto drawing = std::get<Drawing>(pictures::filtered("outlines", tree_of(picture, "learned")));
        ASSERT_EQ(drawing.strokes.size(), mast ? 2u : 1u);
        EXPECT_TRUE(drawing.strokes[0].closed) << "the hull is whole";
        EXPECT_EQ(drawing.strokes[0].line, LineClass::normal);
        if (!mast) continue;
        const Stroke& line = drawing.strokes[1];
        const auto [top, foot] = std::minmax(line.points.front().y, line.points.back().y);
        EXPECT_NEAR(top, 25, 12) << "its tip is faint to the map";
        EXPECT_NEAR(foot, 100, 2);
        for (const Point p : line.points) EXPECT_NEAR(p.x, 115, 1.5);
        EXPECT_LE(std::min(apart(line.points.front(), drawing.strokes[0]), apart(line.points.back(), drawing.strokes[0])), 0.5);
        EXPECT_EQ(line.line, LineClass::thin);
    }
}

// A person points at one of two ships.
TEST(Outlines, TheMastOfASubjectStaysWithIt) {
    SKIP_WITHOUT_WEIGHTS();
    const auto hull = [](int x, int y) { return y > 200 && y < 270 && x > (y - 200) / 2 && x < 160 - (y - 200) / 2; };
    const RegionTree tree = tree_of(scene([&](int x, int y) -> std::array<int, 3> {
                                        if (hull(x - 50, y) || hull(x - 270, y)) return {110, 30, 30};
                                        if ((std::abs(x - 130) <= 1 || std::abs(x - 350) <= 1) && y > 50 && y <= 200)
                                            return {250, 250, 245};
                                        return {110, 160, 210};
                                    }),
                                    "learned");
    const auto masts = [&](const std::string& settings) {
        const auto drawing = std::get<Drawing>(pictures::filtered("outlines " + settings, tree));
        std::array<int, 2> count{0, 0};
        for (const Stroke& stroke : drawing.strokes)
            if (!stroke.closed && stroke.line == LineClass::thin && length_of(stroke) > 40)
                ++count[stroke.points[0].x < 120 ? 0 : 1];
        return count;
    };
    const std::string first = "subject=8%,60%-46%,88%";
    EXPECT_EQ(masts(first), (std::array{1, 1}));
    EXPECT_EQ(masts(first + " only=yes"), (std::array{1, 0}));
    EXPECT_EQ(masts(first + " leave=0%,0%-46%,60%"), (std::array{0, 1}));
}

TEST_P(ThinThingsBy, AreNotInGrainNorAlongABorder) {
    const auto lines_of = [&](const Image& picture) { return tree_of(picture, GetParam()).lines.size(); };
    EXPECT_EQ(lines_of(scene([](int, int) -> std::array<int, 3> { return {128, 128, 128}; }, 40)), 0u);
    EXPECT_EQ(lines_of(scene([](int x, int y) -> std::array<int, 3> {
                  const int level = 130 + static_cast<int>(40 * std::sin(x / 2.0) * std::sin(y / 2.3));
                  return {level, level, level};
              })),
              0u);
    EXPECT_EQ(lines_of(scene([](int, int y) {
                  return y < 160 ? std::array<int, 3>{90, 150, 220} : std::array<int, 3>{60, 100, 40};
              })),
              0u);
}

INSTANTIATE_TEST_SUITE_P(Maps, ThinThingsBy, testing::Values("learned", "plain"),
                         [](const auto& tested) { return std::string(tested.param); });

// What lies in a box, in shares of the drawing, mm.
double line_in(const Drawing& drawing, double left, double top, double right, double bottom) {
    double sum = 0;
    for (const Stroke& stroke : drawing.strokes) {
        const std::vector<Point> points = dense(stroke);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double x = points[i].x / drawing.width, y = points[i].y / drawing.height;
            if (x > left && x < right && y > top && y < bottom) sum += distance(points[i - 1], points[i]);
        }
    }
    return sum;
}

TEST(Portrait, HasAHeadAndInItEyesAndAMouthApart) {
    SKIP_WITHOUT_WEIGHTS();
    const auto recipe =
        std::find_if(named_recipes().begin(), named_recipes().end(), [](const NamedRecipe& r) { return r.name == "portrait"; });
    ASSERT_NE(recipe, named_recipes().end());
    for (const auto face : {"face-anna", "face-ben"}) {
        Image picture = samples::draw_scene(face, 640);
        picture.mm_per_pixel = 246.0 / picture.height;
        Artwork artwork = std::move(picture);
        for (const Step& step : parse_recipe(recipe->text, "portrait", filters()).steps)
            artwork = step.filter->apply(std::move(artwork), step.settings);
        const auto& drawing = std::get<Drawing>(artwork);
        EXPECT_GT(line_in(drawing, 0.30, 0.38, 0.50, 0.46), 16) << face << ": an eye";
        EXPECT_GT(line_in(drawing, 0.53, 0.38, 0.75, 0.46), 16) << face << ": an eye";
        EXPECT_GT(line_in(drawing, 0.30, 0.58, 0.70, 0.70), 16) << face << ": the mouth";
        EXPECT_LT(line_in(drawing, 0, 0, 1, 0.1), 1) << face << ": nothing above the head";
        // Lines that stand by themselves, as features do, are apart from all others by the gap, less what rounding takes.
        const auto& strokes = drawing.strokes;
        int alone = 0;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            if (strokes[i].closed || strokes[i].line != LineClass::thin) continue;
            double from_ends = std::numeric_limits<double>::infinity(), from_all = from_ends;
            for (std::size_t j = 0; j < strokes.size(); ++j) {
                if (j == i) continue;
                from_ends = std::min(
                    {from_ends, apart(strokes[i].points.front(), strokes[j]), apart(strokes[i].points.back(), strokes[j])});
                from_all = std::min(from_all, apart(strokes[i], strokes[j]));
            }
            if (from_ends < 0.5) continue;
            ++alone;
            EXPECT_GT(from_all, 4.1 - 0.5) << face;
        }
        EXPECT_GE(alone, 3) << face << ": brows, a nose, a mouth";
    }
}

TEST(Subject, AFaceThatIsPointedAtHasEyesAndAMouth) {
    SKIP_WITHOUT_WEIGHTS();
    Image picture = samples::draw_scene("face-anna", 640);
    picture.mm_per_pixel = 246.0 / picture.height;
    const RegionTree tree = tree_of(picture, "learned");
    const auto drawing = std::get<Drawing>(pictures::filtered("outlines subject=20%,12%-82%,86% only=yes", tree));
    EXPECT_GT(line_in(drawing, 0.30, 0.38, 0.50, 0.46), 16) << "an eye";
    EXPECT_GT(line_in(drawing, 0.53, 0.38, 0.75, 0.46), 16) << "an eye";
    EXPECT_GT(line_in(drawing, 0.30, 0.58, 0.70, 0.70), 16) << "the mouth";
    double inside = 0, around = 0;
    for (const Stroke& stroke : drawing.strokes) (stroke.line == LineClass::thick ? around : inside) += length_of(stroke);
    EXPECT_LT(inside, 0.65 * around) << "the head's outline leads";
}

}  // namespace
}  // namespace tactics::open_lines_test
