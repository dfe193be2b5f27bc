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

namespace tactics {
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
        outcome = make_pages(job);
        EXPECT_EQ(outcome.error, "");
        return tests::bytes_of(folder / (name + ".page.svg"));
    }

    tests::Folder folder;
    Outcome outcome;
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
}  // namespace tactics
