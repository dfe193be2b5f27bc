// SPDX-License-Identifier: Apache-2.0
// A picture of pixels in a figure of lines is drawn in its own place, and the figure stays what it is.
#include "tactics/job/figure_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "print/base64.h"
#include "tactics/job/figure.h"
#include "tactics/job/make_pages.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/readers/svg/svg.h"
#include "tests/cli/tool.h"
#include "tests/tactics/readers/pictures.h"

namespace tactics::figure_pictures_test {
namespace {

// A dark disc, left and high in its picture, so that what is turned over shows.
std::string picture() {
    Image image = make_image(200, 160, 1, 0, 230);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (std::hypot(x - 60, y - 50) < 35) image.row(y)[x] = 30;
    const auto bytes = png_of(image);
    return to_base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// 200 mm wide and high: a line at the left, a picture in the box from 60,40 to 160,120 mm, and its `more` attributes.
std::string figure_with(const std::string& more = "x='60' y='40' width='100' height='80'", const std::string& around = "<g>") {
    return "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='200mm' viewBox='0 0 200 200'>"
           "<clipPath id='c'><rect x='60' y='40' width='30' height='80'/></clipPath>"
           "<path d='M20 20V180' stroke='black'/>" +
           around + "<image " + more + " href='data:image/png;base64," + picture() + "'/></g></svg>";
}

class FigurePictures : public testing::Test {
protected:
    /// The lines on the page of that figure, as its own SVG has them, without the line at the left; in mm of the figure.
    std::vector<Box> lines_of(const std::string& name, const std::string& svg) {
        tests::write_bytes(folder / name, svg);
        const Job job{{(folder / name).string(), {output_to((folder / (name + ".out.svg")).string())}}, {}};
        const Outcome outcome = make_pages(job);
        EXPECT_EQ(outcome.error, "");
        const Page page = read_svg(tests::bytes_of(folder / (name + ".out.svg")), "out.svg", 0, std::nullopt).page;
        std::vector<Box> boxes;
        for (const PageStroke& stroke : page.strokes) boxes.push_back(box_of(stroke.points));
        if (boxes.empty()) return {};
        // The line at the left is 160 mm of the figure high.
        const auto upright = std::max_element(boxes.begin(), boxes.end(),
                                              [](const Box& a, const Box& b) { return a.bottom - a.top < b.bottom - b.top; });
        const double scale = (upright->bottom - upright->top) / 160, left = upright->left - 20 * scale,
                     top = upright->top - 20 * scale;
        boxes.erase(upright);
        for (Box& box : boxes)
            box = {(box.left - left) / scale, (box.top - top) / scale, (box.right - left) / scale, (box.bottom - top) / scale};
        return boxes;
    }

    tests::Folder folder;
};

Box all_of(const std::vector<Box>& boxes) {
    Box all = kNothing;
    for (const Box& box : boxes) {
        all.take({box.left, box.top});
        all.take({box.right, box.bottom});
    }
    return all;
}

constexpr double kNear = 3;  // mm of the figure, whose page is smaller than it

TEST_F(FigurePictures, ItIsDrawnWhereItStands) {
    const Box disc = all_of(lines_of("a.svg", figure_with()));  // half a mm a pixel
    EXPECT_NEAR(disc.left, 60 + 12.5, kNear);
    EXPECT_NEAR(disc.right, 60 + 47.5, kNear);
    EXPECT_NEAR(disc.top, 40 + 7.5, kNear);
    EXPECT_NEAR(disc.bottom, 40 + 42.5, kNear);
}

TEST_F(FigurePictures, ItStandsOnItsHeadAndMirroredWhereTheFigureHasItSo) {
    // As Matplotlib writes pictures: the file upside down, and drawn with a negative scale.
    const Box down = all_of(lines_of("b.svg", figure_with("x='60' y='-120' width='100' height='80' transform='scale(1 -1)'")));
    EXPECT_NEAR(down.left, 60 + 12.5, kNear);
    EXPECT_NEAR(down.top, 120 - 42.5, kNear);
    const Box mirrored =
        all_of(lines_of("c.svg", figure_with("x='-160' y='40' width='100' height='80' transform='scale(-1 1)'")));
    EXPECT_NEAR(mirrored.right, 160 - 12.5, kNear);
    EXPECT_NEAR(mirrored.top, 40 + 7.5, kNear);
    Image image = make_image(3, 2, 3, 0, 0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(i);
    EXPECT_EQ(turned_over(turned_over(image, true, true), true, true).pixels, image.pixels);
    EXPECT_EQ(turned_over(image, true, true).pixels[0], image.pixels[15]) << "the last pixel's red";
}

TEST_F(FigurePictures, AClipCutsIt) {
    const Box part = all_of(lines_of("d.svg", figure_with("x='60' y='40' width='100' height='80'", "<g clip-path='url(#c)'>")));
    EXPECT_NEAR(part.left, 60 + 12.5, kNear);
    EXPECT_LT(part.right, 90 + 0.5) << "the disc reaches to 107";
}

TEST(FigureParts, WordsThatAClipHidesAreNotSet) {
    FigurePart part{{0, 0, 100, 100}, {0, 0, 50, 100}, {}};
    part.drawable.words.told = {{"seen", 90, 25, 50, true, {25, 50}}, {"hidden", 90, 75, 50, true, {75, 50}}};
    PrintWords words;
    take_words({part}, 200, 200, words);
    ASSERT_EQ(words.told.size(), 1u);
    EXPECT_EQ(words.told[0].text, "seen");
    EXPECT_NEAR(words.told[0].x, 12.5, 1e-9);
}

TEST_F(FigurePictures, WhatIsNoPictureOrATinyOneIsTold) {
    for (const std::string more :
         {"x='60' y='40' width='5' height='5'", "x='60' y='40' width='100' height='80' transform='rotate(30)'"}) {
        tests::write_bytes(folder / "e.svg", figure_with(more));
        const Outcome outcome = make_pages({{(folder / "e.svg").string(), {output_to((folder / "e.pdf").string())}}, {}});
        EXPECT_EQ(outcome.error, "");
        EXPECT_TRUE(std::any_of(outcome.notes.begin(), outcome.notes.end(), [](const Note& note) {
            return note.english().find("1 picture is left out") != std::string::npos;
        })) << more;
    }
}

// Lines stay lines and text stays text beside it; only where pixels are most of the page is it a picture as a whole.
TEST_F(FigurePictures, APageOfAPdfKeepsLinesTextAndPicture) {
    for (const char* program : {"rsvg-convert", "pdftocairo"})
        if (!tests::has_tool(program)) GTEST_SKIP() << program << " is missing";
    const std::string text = "<text x='20' y='190' font-size='8' font-family='DejaVu Sans'>seven words</text></svg>";
    std::string figure = figure_with();
    figure.replace(figure.find("</svg>"), 6, text);
    tests::write_bytes(folder / "f.svg", figure);
    ASSERT_EQ(tests::run_tool(folder, {"rsvg-convert", "-f", "pdf", "-o", "f.pdf", "f.svg"}).code, 0);
    const Source pdf = open_source((folder / "f.pdf").string());
    const auto svg = pdf_page_as_svg(pdf, 1, pdf_text(pdf, 1));
    ASSERT_TRUE(svg);
    EXPECT_NE(svg->find("seven words"), std::string::npos);
    const FoundPage found = read_svg(*svg, "f.pdf", 0, find_paper("a4", ""), SvgPurpose::figure);
    EXPECT_EQ(found.pictures.size(), 1u);
    EXPECT_EQ(found.words.size(), 1u);
    EXPECT_EQ(found.page.strokes.size(), 1u);

    tests::write_bytes(folder / "scan.svg", figure_with("x='2' y='2' width='196' height='157'"));
    ASSERT_EQ(tests::run_tool(folder, {"rsvg-convert", "-f", "pdf", "-o", "scan.pdf", "scan.svg"}).code, 0);
    const Source scan = open_source((folder / "scan.pdf").string());
    EXPECT_FALSE(pdf_page_as_svg(scan, 1, pdf_text(scan, 1)));
}

TEST(PdfPictures, AreCountedAsTheListHasThem) {
    const PdfPictures told = pictures_told(
        "page   num  type   width height color comp bpc  enc interp  object ID x-ppi y-ppi size ratio\n"
        "--------------------------------------------------------------------------------------------\n"
        "   1     0 image     300   200  rgb     3   8  image  no        13  0   100   100 89.1K  57%\n"
        "   1     1 smask     300   200  gray    1   8  image  no        13  0   100   100 1.1K  57%\n"
        "   1     2 image     720    72  gray    1   8  jpeg   no   [inline]   72    72 1.1K  57%\n"
        "   1     3 image\n");
    EXPECT_EQ(told.listed, 3u);
    EXPECT_EQ(told.count, 2u);
    EXPECT_NEAR(told.largest, 720 * 72, 1e-6);
    EXPECT_EQ(pictures_told("").count, 0u);
    EXPECT_EQ(pictures_told("x\ny\n1 0 image 9e999 -5 rgb 3 8 image no 13 0 0 nan 1 1\n").largest, 0);
}

}  // namespace
}  // namespace tactics::figure_pictures_test
