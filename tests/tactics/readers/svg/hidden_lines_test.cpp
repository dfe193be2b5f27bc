// SPDX-License-Identifier: Apache-2.0
// What lies behind an opaque surface is not drawn; all else is.
#include "tactics/readers/svg/hidden_lines.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/tactics/readers/svg/figures.h"

namespace tactics::hidden_lines_test {
namespace {

using tests::figure;

double length_of_all(const FoundPage& found) {
    double length = 0;
    for (const PageStroke& stroke : found.page.strokes) length += length_of(Stroke{stroke.points, stroke.closed});
    return length;
}

const std::string kLine = "<path d='M10,50 L190,50' fill='none' stroke='black' stroke-linecap='round'/>";

std::string box(const std::string& paint, double x = 60, double y = 30) {
    return "<rect x='" + std::to_string(x) + "' y='" + std::to_string(y) + "' width='80' height='40' " + paint + "/>";
}

TEST(HiddenLines, EndAtTheBoxInFrontOfThem) {
    const FoundPage found = figure(kLine + box("fill='white' stroke='black'"));
    ASSERT_EQ(found.page.strokes.size(), 3u);
    EXPECT_NEAR(length_of_all(found), 100 + 240, 1e-6);
    EXPECT_NEAR(found.page.strokes[0].points.back().x, 60, 1e-6);
    EXPECT_NEAR(found.page.strokes[1].points.front().x, 140, 1e-6);
}

TEST(HiddenLines, OfBoxesBehindAreGone) {
    const FoundPage found = figure(box("fill='#cdf' stroke='black'", 55, 25) + box("fill='#cdf' stroke='black'"));
    ASSERT_EQ(found.page.strokes.size(), 2u);
    EXPECT_FALSE(found.page.strokes[0].closed);
    EXPECT_NEAR(length_of_all(found), 240 + 80 + 40 + 5 + 5, 1e-6);
    // All of a small one.
    EXPECT_EQ(figure("<circle cx='100' cy='50' r='6' fill='red' stroke='black'/>" + box("fill='#cdf'")).page.strokes.size(), 1u);
}

TEST(HiddenLines, ShowThroughWhatIsNoCover) {
    for (const std::string paint : {"fill='none' stroke='black'", "fill='#cdf' fill-opacity='0.5' stroke='black'"})
        EXPECT_NEAR(length_of_all(figure(kLine + box(paint))), 180 + 240, 1e-6) << paint;
    EXPECT_NEAR(length_of_all(figure(box("fill='#cdf' stroke='black'") + kLine)), 180 + 240, 1e-6) << "it is in front";
    EXPECT_NEAR(length_of_all(figure(kLine + box("fill='white'"))), 180, 1e-6) << "it makes room for words";
    const std::string marks = "<circle cx='100' cy='50' r='3' fill='white' stroke='black'/>";
    EXPECT_NEAR(figure(kLine + marks).page.strokes[0].points.back().x, 190, 1e-6) << "it sits on the line";
    const std::string along = "<path d='M60,10 L60,90' fill='none' stroke='black' stroke-linecap='round'/>";
    EXPECT_NEAR(length_of_all(figure(along + box("fill='#cdf' stroke='black'"))), 80 + 240, 1e-6) << "it runs along the border";
}

TEST(HiddenLines, AWhiteSurfaceWithALineOfItsOwnBehindItIsACover) {
    EXPECT_NEAR(length_of_all(figure(kLine + box("fill='white'") + box("fill='none' stroke='black'"))), 100 + 240, 1e-6);
}

TEST(HiddenLines, WordsBehindAreToldOf) {
    const std::string words = "<text x='100' y='50' font-size='6' text-anchor='middle'>Conductor</text>";
    const FoundPage found = figure(words + box("fill='#cdf' stroke='black'"));
    ASSERT_EQ(found.words.size(), 1u);
    EXPECT_TRUE(found.words[0].hidden);
    bool told = false;
    for (const Phrase& note : found.notes) told = told || note.english().find("\"Conductor\"") != std::string::npos;
    EXPECT_TRUE(told);
    EXPECT_FALSE(figure(box("fill='#cdf' stroke='black'") + words).words.at(0).hidden);
}

}  // namespace
}  // namespace tactics::hidden_lines_test
