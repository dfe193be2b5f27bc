// SPDX-License-Identifier: Apache-2.0
// What stands in the files besides the drawing: sizes, titles, no clocks, the same bytes everywhere.
#include <clocale>
#include <locale>
#include <thread>

#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/units.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::files_test {
namespace {

using namespace rendered;

const std::vector<std::string> kFormats{"pdf", "ps", "svg", "png", "tiff"};

// In print alone: no braille table has the letters of all alphabets.
Sheet printed_sheet(const char* paper, const std::string& title) {
    Sheet sheet = sheet_of(paper, title);
    sheet.braille_table.clear();
    return sheet;
}

Page small_page(const std::string& title = "Title") { return lay_out(picture_drawing(60, 40), sheet_of("100x80mm", title)); }

TEST(PageFiles, HaveTheirPapersSize) {
    NEED_TOOL("pdfinfo");
    const FileFolder folder;
    for (const char* paper : {"a4", "letter", "a3", "11x11.5", "11x17", "200x150mm", "123.4x77.7mm"})
        for (const Orientation way : {Orientation::portrait, Orientation::landscape}) {
            Sheet sheet = sheet_of(paper);
            sheet.orientation = way;
            const Page page = lay_out(hard_drawing(), sheet);
            ASSERT_EQ(page.width > page.height, way == Orientation::landscape);
            const std::string info = output_of(folder, "pdfinfo " + folder.save("page.pdf", encode(page, "pdf")));
            double width = 0, height = 0;
            const auto at = info.find("Page size:");
            ASSERT_NE(at, std::string::npos) << info;
            ASSERT_EQ(std::sscanf(info.c_str() + at, "Page size: %lf x %lf pts", &width, &height), 2);
            EXPECT_NEAR(width * kMmPerPoint, page.width, 0.001);
            EXPECT_NEAR(height * kMmPerPoint, page.height, 0.001);

            const std::string ps = encode(page, "ps");
            const auto box = ps.find("%%HiResBoundingBox: ");
            const auto media = ps.find("%%DocumentMedia: ");
            const auto device = ps.find("/PageSize [");
            ASSERT_EQ(std::sscanf(ps.c_str() + box, "%%%%HiResBoundingBox: 0 0 %lf %lf", &width, &height), 2);
            EXPECT_NEAR(width * kMmPerPoint, page.width, 0.001);
            ASSERT_EQ(std::sscanf(ps.c_str() + media, "%%%%DocumentMedia: Page %lf %lf 0", &width, &height), 2);
            EXPECT_NEAR(height * kMmPerPoint, page.height, 0.001);
            ASSERT_EQ(std::sscanf(ps.c_str() + device, "/PageSize [%lf %lf]", &width, &height), 2);
            EXPECT_NEAR(width * kMmPerPoint, page.width, 0.001);

            const std::string svg = encode(page, "svg");
            ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("width=\""), "width=\"%lfmm\" height=\"%lfmm\"", &width, &height), 2);
            EXPECT_NEAR(width, page.width, 0.001);
            EXPECT_NEAR(height, page.height, 0.001);
        }
}

TEST(PageFiles, PdfIsClean) {
    NEED_TOOL("qpdf");
    const FileFolder folder;
    std::string many = "All ";
    for (unsigned letter = 0xC0; letter < 0x180; ++letter) {
        many += static_cast<char>(0xC0 | (letter >> 6));
        many += static_cast<char>(0x80 | (letter & 0x3F));
    }
    const Page pages[] = {small_page(), small_page(""), lay_out(hard_drawing(), sheet_of("a4", "Wörter")),
                          lay_out(hard_drawing(), printed_sheet("1000x1000mm", many))};
    for (const Page& page : pages) {
        int code = 0;
        const std::string said = output_of(folder, "qpdf --check " + folder.save("page.pdf", encode(page, "pdf")), &code);
        EXPECT_EQ(code, 0) << said;
        EXPECT_EQ(said.find("WARNING"), std::string::npos) << said;
    }
}

TEST(PageFiles, PdfGivesItsTitleBack) {
    NEED_TOOL("pdftotext");
    const FileFolder folder;
    const std::string title = "Ballon à air, Αθήνα, Київ: 50 % (big) \\o/ <b>";
    folder.save("page.pdf", encode(lay_out(hard_drawing(), printed_sheet("a4", title)), "pdf"));
    EXPECT_EQ(output_of(folder, "pdftotext " + folder.file("page.pdf") + " -").substr(0, title.size() + 1), title + "\n");
    const std::string info = output_of(folder, "pdfinfo " + folder.file("page.pdf"));
    EXPECT_NE(info.find(" " + title + "\n"), std::string::npos) << info;
    EXPECT_EQ(info.find("Date"), std::string::npos) << info;
}

TEST(PageFiles, HostileTitlesAreHarmless) {
    NEED_TOOL("qpdf");
    NEED_TOOL("gs");
    NEED_TOOL("rsvg-convert");
    const FileFolder folder;
    const std::string titles[] = {
        "</svg><script>alert(1)</script>]]>&amp;&#0;\"'",
        ") showpage quit (\\",
        "%!PS\n%%EOF\nstop\r%%Trailer",
        std::string("nul\0in\x01it\x1b[31m\x7f", 15),
        "\xff\xfe\xc0\x80\xed\xa0\x80\xf5\x80",
        "endstream endobj trailer << /Root 9 0 R >> \xef\xbf\xbe \xf4\x8f\xbf\xbf",
        "Combining e\xcc\x81\xcc\x81 and \xe2\x80\xae right to left \xf0\x9f\x90\x98 \xef\xbb\xbf",
    };
    for (const std::string& title : titles) {
        const Page page = lay_out(picture_drawing(60, 40), printed_sheet("a4", title));
        int code = 0;
        EXPECT_EQ((output_of(folder, "qpdf --check " + folder.save("page.pdf", encode(page, "pdf")), &code), code), 0) << title;
        EXPECT_GT(by_ghostscript(folder, encode(page, "ps"), 50).count(), 100) << title;
        const std::string svg = encode(page, "svg");
        const std::string drawn = folder.file("page.png");
        EXPECT_EQ(output_of(folder, "rsvg-convert -o " + drawn + " " + folder.save("page.svg", svg)), "") << title;
        EXPECT_EQ(svg.find("<script"), std::string::npos);
        EXPECT_GT(parse_png(encode(page, "png")).count(), 100);
    }
}

TEST(PageFiles, AreTheSameBytesInEveryLocaleAndThread) {
    const Page page = lay_out(hard_drawing(), sheet_of("a5", "Größe 1,5"));
    std::vector<std::string> first;
    for (const auto& format : kFormats) first.push_back(encode(page, format));
    for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "C.UTF-8"})
        if (std::setlocale(LC_ALL, locale) != nullptr) break;
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    std::vector<std::thread> threads;
    std::vector<int> wrong(4);
    for (auto& count : wrong)
        threads.emplace_back([&] {
            for (std::size_t i = 0; i < kFormats.size(); ++i) count += encode(page, kFormats[i]) != first[i];
        });
    for (auto& thread : threads) thread.join();
    std::locale::global(before);
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(wrong, std::vector<int>(4));
}

TEST(PageFiles, PictureOfItsOwnSizeComesBackPixelForPixel) {
    for (const auto& [width, height] : {std::pair{301, 203}, {7, 9}, {1, 1}, {640, 33}}) {
        Sheet sheet = sheet_of("a4", "not on a bare page");
        sheet.bare = true;
        const Drawing drawing = picture_drawing(width, height);
        const Pixels seen = parse_png(encode(lay_out(drawing, sheet), "png", {{"width", std::to_string(width)}}));
        ASSERT_EQ(seen.width, width);
        ASSERT_EQ(seen.height, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) ASSERT_EQ(seen.at(x, y), drawing.picture->row(y)[x] == 0) << x << " " << y;
    }
}

TEST(PageFiles, PixelsTellTheirSizeOnPaper) {
    const std::string png = encode(small_page(), "png", {{"dpi", "600"}});
    const auto at = png.find("pHYs");
    ASSERT_NE(at, std::string::npos);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(png[at + 4 + i]); };
    EXPECT_NEAR(byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3), 600 / 0.0254, 10);
    EXPECT_EQ(byte(8), 1);
    const FileFolder folder;
    TIFF* tiff = TIFFOpen(folder.save("page.tiff", encode(small_page(), "tiff", {{"dpi", "600"}})).c_str(), "r");
    ASSERT_NE(tiff, nullptr);
    float across = 0;
    std::uint16_t unit = 0, compression = 0, bits = 0;
    TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &across);
    TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
    TIFFGetField(tiff, TIFFTAG_COMPRESSION, &compression);
    TIFFGetField(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFClose(tiff);
    EXPECT_NEAR(across, 600, 0.2);
    EXPECT_EQ(unit, RESUNIT_INCH);
    EXPECT_EQ(compression, COMPRESSION_CCITTFAX4);
    EXPECT_EQ(bits, 1);
}

TEST(PageFiles, TooManyPixelsAreRefusedWithWhatCanBeHad) {
    const Page page = lay_out(hard_drawing(), sheet_of("5000x5000mm"));
    for (const std::string format : {"png", "tiff"}) {
        try {
            encode(page, format, {{"dpi", "2400"}});
            ADD_FAILURE() << format;
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::usage);
            EXPECT_EQ(error.what(),
                      format + ": the page would be 472441 x 472441 pixels; ask for at most 159 dpi (31306 pixels across)");
        }
    }
    EXPECT_THROW(encode(page, "png", {{"width", "200000"}}), Error);
}

TEST(PageFiles, SvgHasLayersWithNames) {
    Drawing drawing = hard_drawing();
    drawing.picture = picture_drawing(60, 40).picture;
    const std::string svg = encode(lay_out(drawing, sheet_of("a4", "A <title>")), "svg");
    for (const char* part : {"inkscape:label=\"ground\"", "inkscape:label=\"inner lines\"", "inkscape:label=\"main outlines\"",
                             "inkscape:label=\"words\"", "inkscape:label=\"braille\"", "inkscape:label=\"title\"",
                             "id=\"picture\"", "<title id=\"title\">A &lt;title&gt;</title>", "<desc id=\"desc\""})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace tactics::files_test
