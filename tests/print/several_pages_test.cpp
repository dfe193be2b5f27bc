// SPDX-License-Identifier: Apache-2.0
// Documents of several pages, read by independent programs: the right number of pages, each the same as alone.
#include "tactics/layout/lay_out.h"
#include "tests/print/brf_reader.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::several_pages_test {
namespace {

using namespace rendered;

constexpr int kDpi = 60;

// Of one size, with lines, letters, braille and pixels.
std::vector<Page> three_pages() {
    return {lay_out(hard_drawing(), sheet_of("a5", "First Äpfel")), lay_out(picture_drawing(300, 200), sheet_of("a5", "Second")),
            lay_out(Drawing{180, 120, {Stroke{{{0, 0}, {180, 120}}}}, {}, {}}, sheet_of("a5", "Third"))};
}

std::string together(const std::vector<Page>& pages, const char* name) {
    const Format& format = *find_format(name);
    const auto files = files_of(format, pages, Settings(format.options));
    EXPECT_EQ(files.size(), 1u) << name;
    return files.front();
}

void expect_same(const Pixels& one, const Pixels& other) {
    EXPECT_EQ(one.width, other.width);
    EXPECT_EQ(one.height, other.height);
    EXPECT_GT(one.count(), 100);
    EXPECT_EQ(disagreements(one, other, 0), 0);
}

// print/format.cpp includes three lists, which a tool that sorts includes would put in another order.
TEST(Formats, KindsOfFilesComeFirstThenEmbossersThenDisplays) {
    std::vector<std::string_view> names;
    for (const Format* format : formats()) names.push_back(format->name);
    const auto place_of = [&](std::string_view name) { return std::find(names.begin(), names.end(), name) - names.begin(); };
    EXPECT_EQ(place_of("pdf"), 0);
    EXPECT_LT(place_of("text"), place_of("generic"));
    EXPECT_LT(place_of("viewplus"), place_of("dot-pad"));
    EXPECT_LT(place_of("graphiti"), std::ssize(names));
}

TEST(SeveralPages, OnePageHasTheSameBytesEitherWay) {
    for (const Page& page : three_pages())
        for (const Format* format : formats())
            if (format->encode_pages != nullptr) {
                const Settings settings(format->options);
                Page own = page;
                if (format->dots != nullptr) {
                    own.bed = format->dots(settings).bed;
                    own.cell = format->dots(settings).cell;
                }
                EXPECT_EQ(format->encode_pages({&own, 1}, settings), format->encode(own, settings)) << format->name;
            }
}

TEST(SeveralPages, PdfHoldsThemAll) {
    NEED_TOOL("pdftoppm");
    NEED_TOOL("qpdf");
    const FileFolder folder;
    const std::vector<Page> pages = three_pages();
    const std::string path = folder.save("all.pdf", together(pages, "pdf"));
    int code = 0;
    const std::string said = output_of(folder, "qpdf --check " + path, &code);
    EXPECT_EQ(code, 0) << said;
    EXPECT_EQ(said.find("WARNING"), std::string::npos) << said;
    EXPECT_EQ(output_of(folder, "qpdf --show-npages " + path), "3\n");
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        EXPECT_EQ(output_of(folder, "qpdf --empty --pages " + path + " " + number + " -- " + folder.file("one.pdf")), "");
        expect_same(by_poppler(folder, read_file(folder.file("one.pdf")), kDpi),
                    by_poppler(folder, encode(pages[i], "pdf"), kDpi));
    }
    // A screen reader finds the words of each.
    const std::string words = output_of(folder, "pdfinfo -struct-text " + path);
    std::size_t at = 0;
    for (const char* title : {"First Äpfel", "Second", "Third"}) {
        at = words.find(title, at);
        ASSERT_NE(at, std::string::npos) << title << " in " << words;
    }
}

TEST(SeveralPages, PostScriptHoldsThemAll) {
    NEED_TOOL("gs");
    const FileFolder folder;
    const std::vector<Page> pages = three_pages();
    const std::string text = together(pages, "ps");
    EXPECT_NE(text.find("%%Pages: 3\n"), std::string::npos);
    EXPECT_EQ(
        output_of(folder, "gs -q -dBATCH -dNOPAUSE -sDEVICE=pgmraw -dGraphicsAlphaBits=4 -dTextAlphaBits=4 -r60 -sOutputFile=" +
                              folder.file("page%d.pgm") + " " + folder.save("all.ps", text)),
        "");
    for (std::size_t i = 0; i < pages.size(); ++i)
        expect_same(parse_pnm(read_file(folder.file("page" + std::to_string(i + 1) + ".pgm"))),
                    by_ghostscript(folder, encode(pages[i], "ps"), kDpi));
    EXPECT_FALSE(std::filesystem::exists(folder.file("page4.pgm")));
}

TEST(SeveralPages, TiffHoldsThemAll) {
    const FileFolder folder;
    const std::vector<Page> pages = three_pages();
    TIFF* tiff = TIFFOpen(folder.save("all.tiff", together(pages, "tiff")).c_str(), "r");
    ASSERT_NE(tiff, nullptr);
    EXPECT_EQ(TIFFNumberOfDirectories(tiff), 3u);
    for (std::uint16_t i = 0; i < 3; ++i) {
        ASSERT_EQ(TIFFSetDirectory(tiff, i), 1);
        std::uint32_t kind = 0, width = 0, height = 0;
        std::uint16_t number = 9, count = 0, photometric = 9;
        float across = 0;
        TIFFGetField(tiff, TIFFTAG_SUBFILETYPE, &kind);
        TIFFGetField(tiff, TIFFTAG_PAGENUMBER, &number, &count);
        TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
        TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
        TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &across);
        EXPECT_EQ(kind, static_cast<std::uint32_t>(FILETYPE_PAGE));
        EXPECT_EQ(number, i);
        EXPECT_EQ(count, 3);
        EXPECT_NEAR(across, 300, 0.2);
        ASSERT_EQ(photometric, PHOTOMETRIC_MINISWHITE);
        Pixels seen{static_cast<int>(width), static_cast<int>(height), {}};
        std::vector<std::uint8_t> row(static_cast<std::size_t>(TIFFScanlineSize(tiff)));
        for (std::uint32_t y = 0; y < height; ++y) {
            ASSERT_EQ(TIFFReadScanline(tiff, row.data(), y, 0), 1);
            for (std::uint32_t x = 0; x < width; ++x) seen.black.push_back((row[x / 8] >> (7 - x % 8)) & 1u);
        }
        expect_same(seen, by_libtiff(folder, encode(pages[i], "tiff")));
    }
    TIFFClose(tiff);
}

TEST(SeveralPages, TextsKeepThemApartByFormFeeds) {
    const std::vector<Page> pages = three_pages();
    const auto sheets = test::read_brf(together(pages, "brf"));
    ASSERT_EQ(sheets.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(sheets[i].lines, test::read_brf(encode(pages[i], "brf")).at(0).lines);
    EXPECT_EQ(together(pages, "text"),
              encode(pages[0], "text") + "\f" + encode(pages[1], "text") + "\f" + encode(pages[2], "text"));
}

TEST(SeveralPages, PixelsAndSvgAreAFileEach) {
    const std::vector<Page> pages = three_pages();
    for (const char* name : {"png", "svg", "heightmap"}) {
        const Format& format = *find_format(name);
        const auto files = files_of(format, pages, Settings(format.options));
        ASSERT_EQ(files.size(), 3u) << name;
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(files[i], encode(pages[i], name)) << name;
    }
}

}  // namespace
}  // namespace tactics::several_pages_test
