// SPDX-License-Identifier: Apache-2.0
// The same page through every format and an independent reader: they agree within one device pixel, and lines and dots
// measure what they should.
#include <functional>
#include <numbers>

#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::agreement_test {
namespace {

using namespace rendered;

constexpr int kDpi = 600;
constexpr double kPixel = 25.4 / kDpi;  // mm

struct Road {
    std::string name;
    std::string tool;
    int picture_reach;  // device pixels within which pictures agree
    bool own_fonts;     // sets print with its own fonts, so print is left out
    std::function<Pixels(const FileFolder&, const Page&)> pixels;
    int curve_reach = 0;  // besides a pixel: lines are drawn as curves so near to them
};

void PrintTo(const Road& road, std::ostream* out) { *out << road.name; }

const Values kFine{{"dpi", std::to_string(kDpi)}};

Pixels by_libpng(const Page& page) { return parse_png(encode(page, "png", kFine)); }

// Poppler sets pictures down on whole device pixels, up to one off on either side. Librsvg always smooths them, which moves
// corners by up to half a pixel of the picture; pixels here are 6 device pixels large.
const std::vector<Road> kRoads{
    {"PdfByPoppler", "pdftoppm", 2, false,
     [](const FileFolder& f, const Page& p) { return by_poppler(f, encode(p, "pdf"), kDpi); }},
    {"PdfByGhostscript", "gs", 1, false,
     [](const FileFolder& f, const Page& p) { return by_ghostscript(f, encode(p, "pdf"), kDpi); }},
    {"PsByGhostscript", "gs", 1, false,
     [](const FileFolder& f, const Page& p) { return by_ghostscript(f, encode(p, "ps"), kDpi); }},
    {"SvgByLibrsvg", "rsvg-convert", 3, true,
     [](const FileFolder& f, const Page& p) { return by_librsvg(f, encode(p, "svg"), kDpi); }, 3},
    {"TiffByLibtiff", "", 1, false, [](const FileFolder& f, const Page& p) { return by_libtiff(f, encode(p, "tiff", kFine)); }},
    {"PngByLibpng", "", 1, false, [](const FileFolder&, const Page& p) { return by_libpng(p); }},
};

class Agreement : public ::testing::TestWithParam<Road> {
protected:
    void SetUp() override {
        if (!GetParam().tool.empty()) NEED_TOOL(GetParam().tool);
    }
    FileFolder folder_;

    void expect_same_as_png(Page page, int reach) {
        if (GetParam().own_fonts) page.print.clear();
        const Pixels seen = GetParam().pixels(folder_, page);
        const Pixels own = by_libpng(page);
        EXPECT_NEAR(seen.width, own.width, 1);
        EXPECT_NEAR(seen.height, own.height, 1);
        EXPECT_GT(own.count(), 10'000);
        EXPECT_EQ(disagreements(seen, own, reach), 0);
    }
};

TEST_P(Agreement, Vectors) {
    expect_same_as_png(lay_out(hard_drawing(), sheet_of("a5", "Äpfel, Größe & (more)")), 1 + GetParam().curve_reach);
}

TEST_P(Agreement, Picture) {
    expect_same_as_png(lay_out(picture_drawing(301, 203), sheet_of("100x80mm")), GetParam().picture_reach);
}

TEST_P(Agreement, LineWidths) {
    // Fifteen lines in cells of 40 mm; a line's width follows from its area, that of a rectangle with two half discs.
    constexpr double kCell = 40, kLength = 30;
    const double angles[] = {0, 17, 45, 73, 90};
    const LineClass classes[] = {LineClass::thin, LineClass::normal, LineClass::thick};
    const double widths[] = {0.7, 1.0, 3.0};
    Drawing drawing;
    drawing.width = 5 * kCell;
    drawing.height = 3 * kCell;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 5; ++column) {
            const double angle = angles[column] * std::numbers::pi / 180;
            const Point middle{(column + 0.5) * kCell, (row + 0.5) * kCell};
            const Point half{std::cos(angle) * kLength / 2, std::sin(angle) * kLength / 2};
            drawing.strokes.push_back(
                {{{middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}}, false, classes[row], 0});
        }
    Sheet sheet = sheet_of("a4");
    sheet.drawing_width = drawing.width;
    const Rect place = place_on(sheet, drawing.width / drawing.height).drawing;
    const Pixels seen = GetParam().pixels(folder_, lay_out(drawing, sheet));
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 5; ++column) {
            const auto px = [&](double mm) { return static_cast<int>(std::lround(mm / kPixel)); };
            const double left = place.left + column * kCell, top = place.top + row * kCell;
            const long pixels = seen.count(px(left), px(top), px(left + kCell), px(top + kCell));
            const double area = kPixel * kPixel * static_cast<double>(pixels);
            const double width = (std::sqrt(kLength * kLength + std::numbers::pi * area) - kLength) * 2 / std::numbers::pi;
            EXPECT_NEAR(width, widths[row], kPixel) << "at " << angles[column] << " degrees";
        }
}

TEST_P(Agreement, BrailleDots) {
    Page page = lay_out(hard_drawing(), sheet_of("a5"));
    page.strokes.clear();
    page.areas.clear();
    page.braille = {{{20, 20}, {0x3F, 0x01, 0x00, 0x20}}};
    const Pixels seen = GetParam().pixels(folder_, page);
    for (const Point& dot : dots_of(page.braille[0], page.cell)) {
        // Its area and centre of gravity within a window that reaches halfway to the next dot.
        const int left = static_cast<int>((dot.x - 1.2) / kPixel), top = static_cast<int>((dot.y - 1.2) / kPixel);
        const int side = static_cast<int>(2.4 / kPixel);
        double sum = 0, sum_x = 0, sum_y = 0;
        for (int y = top; y < top + side; ++y)
            for (int x = left; x < left + side; ++x)
                if (seen.at(x, y)) {
                    sum += 1;
                    sum_x += x + 0.5;
                    sum_y += y + 0.5;
                }
        EXPECT_NEAR(2 * std::sqrt(sum / std::numbers::pi) * kPixel, page.braille_dot, kPixel);
        EXPECT_NEAR(sum_x / sum * kPixel, dot.x, kPixel);
        EXPECT_NEAR(sum_y / sum * kPixel, dot.y, kPixel);
    }
    EXPECT_NEAR(std::sqrt(static_cast<double>(seen.count()) / 8 * 4 / std::numbers::pi) * kPixel, page.braille_dot, kPixel);
}

INSTANTIATE_TEST_SUITE_P(Roads, Agreement, ::testing::ValuesIn(kRoads), [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace tactics::agreement_test
