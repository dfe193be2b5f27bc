// SPDX-License-Identifier: Apache-2.0
// Printed letters: as large as another program sets them, and never past the margin.
#include "print/letters.h"

#include "tactics/layout/lay_out.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::letters_test {
namespace {

using namespace rendered;

struct Box {
    int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;
};

Box box_of(const Pixels& pixels) {
    Box box;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x)
            if (pixels.at(x, y))
                box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    return box;
}

Page print_only(const Sheet& sheet) {
    Page page = lay_out(hard_drawing(), sheet);
    page.strokes.clear();
    page.areas.clear();
    page.braille.clear();
    return page;
}

TEST(Letters, StandWhereAnotherProgramSetsThem) {
    NEED_TOOL("rsvg-convert");
    NEED_TOOL("fc-match");
    const FileFolder folder;
    if (output_of(folder, "fc-match 'DejaVu Sans' family").find("DejaVu Sans") != 0)
        GTEST_SKIP() << "DejaVu Sans is not installed";
    const Page page = print_only(sheet_of("a5", "Hamburgefonts Ägypten 123 (jÅ)"));
    const Box own = box_of(parse_png(encode(page, "png", {{"dpi", "300"}})));
    const Box other = box_of(by_librsvg(folder, encode(page, "svg"), 300));
    EXPECT_GT(own.right - own.left, 500);
    EXPECT_NEAR(own.left, other.left, 2);
    EXPECT_NEAR(own.top, other.top, 2);
    EXPECT_NEAR(own.bottom, other.bottom, 2);
    // Other programs round each letter's advance, so the ends drift apart a little.
    EXPECT_NEAR(own.right, other.right, 0.01 * (own.right - own.left));
}

TEST(Letters, StayWithinTheMargins) {
    std::vector<std::string> titles{std::string(300, 'W'), std::string(300, 'm'), std::string(55, '@'), "Short"};
    for (int first = '!'; first <= '~'; first += 6) {  // all of ASCII, six letters to a title
        std::string& title = titles.emplace_back();
        for (int i = 0; i < 120; ++i) title += static_cast<char>(std::min<int>(first + i % 6, '~'));
    }
    for (const char* letters : {"ÆŒǼÐŁŊ", "ШЩЮЖФЫ", "ΩΨΦΘΞΔ", "‰…—™№€", "ﷺ𝕎🙂漢"}) {
        std::string& title = titles.emplace_back();
        for (int i = 0; i < 20; ++i) title += letters;
    }
    for (const std::string& title : titles) {
        Sheet sheet = sheet_of("a5", title);
        sheet.braille_table.clear();
        const Page page = print_only(sheet);
        const Pixels seen = parse_png(encode(page, "png", {{"dpi", "200"}}));
        const Box box = box_of(seen);
        const double mm = 25.4 / 200;
        EXPECT_GE((box.left + 1) * mm, page.live.left) << title;
        EXPECT_GE((box.top + 1) * mm, page.live.top) << title;
        EXPECT_LE(box.right * mm, page.live.left + page.live.width) << title;
        EXPECT_LE(box.bottom * mm, page.live.top + 1.2 * page.print[0].size) << title;
    }
}

TEST(Letters, BytesThatAreNoTextDrawNothing) {
    Page page = print_only(sheet_of("a5", "x"));
    page.print = {{{20, 20}, 5, "\xff\xc0"}};
    EXPECT_TRUE(letters_of(page).empty());
    for (const char* format : {"pdf", "ps", "png"}) EXPECT_FALSE(encode(page, format).empty());
}

}  // namespace
}  // namespace tactics::letters_test
