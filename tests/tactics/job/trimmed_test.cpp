// SPDX-License-Identifier: Apache-2.0
// White around figures is not drawn.
#include "tactics/job/trimmed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "filters/list.h"
#include "tactics/geometry/box.h"
#include "tactics/job/make_pages.h"
#include "tests/cli/picture.h"
#include "tests/cli/tool.h"

namespace tactics::trimmed_test {
namespace {

Image with_square(int width, int height, int left, int top, int side) {
    Image image = make_image(width, height, 1, 0, 230);
    for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) image.row(y)[x] = 40;
    return image;
}

TEST(Trimmed, WhatStandsOutIsLeftWithALittleAroundIt) {
    const Rect part = inked_part(with_square(400, 200, 100, 60, 100));
    EXPECT_NEAR(part.left * 400, 99, 0.1);
    EXPECT_NEAR(part.top * 200, 59, 0.1);
    EXPECT_NEAR((part.left + part.width) * 400, 201, 0.1);
    EXPECT_NEAR((part.top + part.height) * 200, 161, 0.1);
    Image specks = with_square(400, 200, 100, 60, 100);
    specks.row(5)[5] = 0;
    EXPECT_EQ(inked_part(specks).left, part.left) << "a speck is no figure";
}

TEST(Trimmed, APhotographAndAnEmptyPictureStayWhole) {
    Image photograph = make_image(200, 150, 1, 0, 0);
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x) photograph.row(y)[x] = static_cast<std::uint8_t>(x);
    for (const Image& picture : {photograph, make_image(200, 150, 1, 0, 255)}) {
        const Rect part = inked_part(picture);
        EXPECT_EQ(part.width, 1);
        EXPECT_EQ(part.height, 1);
    }
}

TEST(Trimmed, PaleAreasAndLinesOfOnePixelAreInk) {
    for (const bool colour : {false, true}) {
        Image picture = make_image(400, 300, colour ? 3 : 1, 0, 255);
        const auto set = [&](int x, int y, std::uint8_t level) { picture.row(y)[(x + 1) * picture.channels - 1] = level; };
        for (int x = 150; x < 250; ++x) set(x, 150, 0);
        for (int y = 40; y < 90; ++y)
            for (int x = 60; x < 120; ++x) set(x, y, 240);  // of a coloured picture only one channel
        for (int y = 30; y < 270; ++y) set(320, y, 0);
        const Rect part = inked_part(picture);
        EXPECT_NEAR(part.left * 400, 57.4, 0.2);
        EXPECT_NEAR((part.left + part.width) * 400, 323.6, 0.2);
        EXPECT_NEAR(part.top * 300, 27.4, 0.2);
        EXPECT_NEAR((part.top + part.height) * 300, 272.6, 0.2);
    }
}

class TrimmedPages : public testing::Test {
protected:
    // A box with a line across, with that much white around it.
    std::string page_of(int white, const std::string& name, const Wishes& wishes = {}) {
        const auto at = [&](int n) { return std::to_string(n + white); };
        tests::write_bytes(folder / (name + ".svg"),
                           "<svg xmlns='http://www.w3.org/2000/svg' width='" + at(white + 200) + "' height='" + at(white + 100) +
                               "'><path fill='none' stroke='black' stroke-width='2' d='M" + at(0) + " " + at(0) +
                               "h200v100h-200zM" + at(0) + " " + at(0) + "l200 100'/><text x='" + at(130) + "' y='" + at(40) +
                               "' font-size='12'>Slope</text></svg>");
        Job job{{(folder / (name + ".svg")).string(), {output_to((folder / (name + ".page.svg")).string())}}, wishes};
        job.labels = labels;
        outcome = make_pages(job);
        EXPECT_EQ(outcome.error, "");
        return tests::bytes_of(folder / (name + ".page.svg"));
    }

    tests::Folder folder;
    Outcome outcome;
    std::vector<PlacedWords> labels;
};

// The size of its lines in mm on the page does not depend on the white that the file has around them.
TEST_F(TrimmedPages, MoreWhiteAroundItChangesNothing) {
    page_of(4, "close");
    const Rect close = outcome.layouts.at(0).place.drawing;
    const double length = outcome.layouts.at(0).stroke_length;
    page_of(300, "far");
    const Rect far = outcome.layouts.at(0).place.drawing;
    EXPECT_NEAR(far.width, close.width, 0.02 * close.width);
    EXPECT_NEAR(outcome.layouts.at(0).stroke_length, length, 0.03 * length);
    EXPECT_LT(outcome.part.width, 0.3);
    ASSERT_EQ(outcome.words.size(), 1u);
    EXPECT_TRUE(outcome.words[0].set);
}

TEST_F(TrimmedPages, WhoMeasuresTheWholeFigureGetsIt) {
    Wishes wishes;
    wishes.sheet.drawing_width = 100;
    page_of(300, "measured", wishes);
    EXPECT_EQ(outcome.part.width, 1);
    EXPECT_EQ(outcome.layouts.at(0).place.drawing.width, 100);
}

// Whatever a recipe finds in a picture lies within the drawing, and none of it is lost.
TEST_F(TrimmedPages, NothingIsDrawnOutsideOrLost) {
    const auto thin = [](int x, int y) {  // a box, and an axis of one pixel to its left
        const bool box = x >= 300 && x < 700 && y >= 300 && y < 600 && (x < 306 || x >= 694 || y < 306 || y >= 594);
        return box || (x == 200 && y >= 250 && y < 650) ? 0 : 255;
    };
    const auto pale = [](int x, int y) {  // a dark square, and a pale one
        if (x >= 500 && x < 800 && y >= 300 && y < 600) return 30;
        return x >= 150 && x < 400 && y >= 300 && y < 600 ? 232 : 255;
    };
    const auto check = [&](const std::string& name, const std::string& bytes, std::string_view recipe, double left,
                           double right) {
        tests::write_bytes(folder / name, bytes);
        Job job{{(folder / name).string(), {output_to((folder / "page.svg").string())}}, {}};
        job.recipe = find_recipe(recipe, "test");
        job.outputs.front().path.clear();
        outcome = make_pages(job);
        ASSERT_EQ(outcome.error, "");
        EXPECT_LT(outcome.part.width, 0.9);
        EXPECT_LE(outcome.part.left, left / 1000);
        EXPECT_GE(outcome.part.left + outcome.part.width, right / 1000);
        const Layout& layout = outcome.layouts.at(0);
        Box box = kNothing;
        for (const PageStroke& stroke : layout.shown.at(0).strokes)
            for (const Point& p : stroke.points) box.take(p);
        for (const Area& area : layout.shown.at(0).areas)
            for (const auto& ring : area.rings)
                for (const Point& p : ring) box.take(p);
        const Rect& place = layout.place.drawing;
        const double mm = place.width / (outcome.part.width * 1000), slack = 3;
        const double at_left = place.left + (left - 1000 * outcome.part.left) * mm,
                     at_right = place.left + (right - 1000 * outcome.part.left) * mm;
        EXPECT_NEAR(box.left, at_left, slack) << name;
        EXPECT_NEAR(box.right, at_right, slack) << name;
        EXPECT_TRUE(box.left >= place.left && box.right <= place.left + place.width) << name;
        EXPECT_TRUE(box.top >= place.top && box.bottom <= place.top + place.height) << name;
    };
    check("thin.tif", tests::grey_picture(1000, 900, thin), "line-art", 200, 700);
    check("pale.tif", tests::grey_picture(1000, 900, pale), "diagram", 150, 800);
}

// Pixels, as few as they are: a small figure on a large picture is no reason to work on 16 million pixels.
TEST_F(TrimmedPages, WhatHasFewPixelsAsReadStaysWhole) {
    const auto small = [](int x, int y) { return x >= 3000 && x < 3400 && y >= 1000 && y < 1300 ? 0 : 255; };
    tests::write_bytes(folder / "large.tif", tests::grey_picture(7000, 2000, small));
    Job job{{(folder / "large.tif").string(), {output_to((folder / "page.svg").string())}}, {}};
    job.recipe = find_recipe("diagram", "test");
    job.outputs.front().path.clear();
    outcome = make_pages(job);
    ASSERT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.part.width, 1);
}

TEST_F(TrimmedPages, LabelsInMmStandBesideWordsOfPrint) {
    labels = {{12, 50, false, "Foo", "test"}};
    page_of(100, "mm");
    EXPECT_EQ(outcome.part.width, 1);
    ASSERT_EQ(outcome.layouts.at(0).names.size(), 2u);
}

// A thing in the white that is not drawn has its name beside the drawing, and no line leads into the margin.
TEST_F(TrimmedPages, ALabelInTheWhiteKeepsTheRules) {
    labels = {{0.02, 0.5, true, "Foobar here", "test"}, {0.98, 0.02, true, "Above", "test"}};
    page_of(100, "white");
    EXPECT_LT(outcome.part.width, 0.9);
    for (const BrokenRule& rule : outcome.layouts.at(0).broken) EXPECT_FALSE(rule.hard) << rule.name;
}

// A side of 200 mm at 1:4: what is measured on the page is what the scale says.
TEST_F(TrimmedPages, AScaleIsThatOfTheWholeFigure) {
    tests::write_bytes(folder / "plan.svg",
                       "<svg xmlns='http://www.w3.org/2000/svg' width='400mm' height='300mm' viewBox='0 0 400 300'><path "
                       "fill='none' stroke='black' d='M100 100h200v100h-200z'/></svg>");
    Wishes wishes;
    wishes.sheet.scale = 0.25;
    Job job{{(folder / "plan.svg").string(), {output_to((folder / "plan.page.svg").string())}}, wishes};
    job.outputs.front().path.clear();  // shown
    outcome = make_pages(job);
    ASSERT_EQ(outcome.error, "");
    Box box = kNothing;
    for (const PageStroke& stroke : outcome.layouts.at(0).shown.at(0).strokes)
        if (stroke.role == Role::line)
            for (const Point& p : stroke.points) box.take(p);
    EXPECT_NEAR(box.width(), 50, 0.5);
    EXPECT_NEAR(box.height(), 25, 0.5);
}

}  // namespace
}  // namespace tactics::trimmed_test
