// SPDX-License-Identifier: Apache-2.0
// PEF and Unicode braille: the same cells as an embosser gets, in files that other programs read.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "print/embosser.h"
#include "print/format.h"
#include "tests/patterns.h"
#include "tests/print/rendered_page.h"

namespace tactics::pef_test {
namespace {

using namespace rendered;

Page page_with(const Format& format, const Settings& settings, double shift) {
    Page page;
    page.width = 279.4;
    page.height = 292.1;
    page.live = {6, 6, 267, 280};
    page.title = "Ice & <snow>";
    page.cell = format.dots(settings).cell;
    page.bed = format.dots(settings).bed;
    page.strokes.push_back({{{20, 40 + shift}, {150, 90}, {60, 200}}, true, 1.6});
    page.braille.push_back({page.bed->first, {0x01, 0x3F}});
    return page;
}

Settings with(const Format& format, std::string_view dots) {
    Settings settings(format.options);
    settings.set("dots", dots, "test", format.name);
    return settings;
}

std::vector<std::string> unicode_by_machine(std::string_view dots, double shift) {
    const Format& generic = *find_format("generic");
    const Settings settings = with(generic, dots);
    const Page page = page_with(generic, settings, shift);
    return unicode_of(generic.embosser->punch(generic.encode(page, settings), settings).sheets.at(0), 2.5);
}

TEST(Pef, HoldsTheCellsOfEachPage) {
    const Format& pef = *find_format("pef");
    for (const std::string_view dots : {"6", "8"}) {
        const Settings settings = with(pef, dots);
        const std::string text =
            pef.encode_pages(std::vector<Page>{page_with(pef, settings, 0), page_with(pef, settings, 30)}, settings);
        std::vector<std::vector<std::string>> pages;
        std::size_t columns = 0, rows = 0;
        for (const tests::Fit& part : tests::all_fits(
                 text,
                 "<volume cols=\"(\\d+)\" rows=\"(\\d+)\" rowgap=\"0\" duplex=\"false\">|<page>|<row/>|<row>([^<]*)</row>")) {
            if (part[0].starts_with("<volume")) {
                columns = std::stoul(part[1]);
                rows = std::stoul(part[2]);
            } else if (part[0] == "<page>") {
                pages.emplace_back();
            } else {
                pages.back().push_back(part[3]);
            }
        }
        ASSERT_EQ(pages.size(), 2u);
        EXPECT_EQ(columns, 44u);
        EXPECT_EQ(rows, 28u);
        for (const auto& page : pages) {
            EXPECT_LE(page.size(), rows);
            for (const std::string& row : page) EXPECT_LE(row.size(), 3 * columns);
        }
        EXPECT_EQ(pages[0], unicode_by_machine(dots, 0));
        EXPECT_EQ(pages[1], unicode_by_machine(dots, 30));
        EXPECT_NE(text.find("<dc:title>Ice &amp; &lt;snow&gt;</dc:title>"), std::string::npos);
    }
}

// What the specification asks of a head, and that any XML reader takes the file.
TEST(Pef, IsXmlWithTheHeadItMustHave) {
    NEED_TOOL("python3");
    const FileFolder folder;
    const Format& pef = *find_format("pef");
    const Settings settings(pef.options);
    folder.save("page.pef", pef.encode(page_with(pef, settings, 0), settings));
    folder.save("read.py",
                "import sys, xml.etree.ElementTree as tree\n"
                "pef, dc = '{http://www.daisy.org/ns/2008/pef}', '{http://purl.org/dc/elements/1.1/}'\n"
                "root = tree.parse(sys.argv[1]).getroot()\n"
                "meta = root.find(pef + 'head/' + pef + 'meta')\n"
                "print(root.tag == pef + 'pef', root.get('version'), meta.find(dc + 'format').text, bool(meta.find(dc + "
                "'identifier').text),\n"
                "      all(0x2800 <= ord(c) <= 0x28FF for row in root.iter(pef + 'row') for c in row.text or ''))\n");
    EXPECT_EQ(output_of(folder, "python3 " + folder.file("read.py") + " " + folder.file("page.pef")),
              "True 2008-1 application/x-pef+xml True True\n");
}

class PefGrammar : public testing::Test {
protected:
    /// What xmllint says, empty if it has nothing against the file.
    std::string wrong_with(const std::string& text, const std::string& grammar = "pef.rng") {
        int code = 0;
        const std::string said = output_of(folder,
                                           "xmllint --noout --relaxng " TACTICS_SOURCE_DIR "/tests/print/formats/" + grammar +
                                               " " + folder.save("page.pef", text),
                                           &code);
        return code == 0 ? "" : said;
    }
    static Page page_of(const Settings& settings, double shift) { return page_with(*find_format("pef"), settings, shift); }
    static Page empty_page(const Settings& settings) {
        Page page = page_of(settings, 0);
        page.strokes.clear();
        page.braille.clear();
        return page;
    }
    FileFolder folder;
};

TEST_F(PefGrammar, TakesAllThatWeWrite) {
    NEED_TOOL("xmllint");
    const Format& pef = *find_format("pef");
    for (const std::string_view dots : {"6", "8"}) {
        const Settings settings = with(pef, dots);
        Page other = page_of(settings, 30);
        for (const auto& [title, language] :
             {std::pair{"", "en"}, {"Fish & <chips> \"now\" ]]>", "en-GB"}, {"Żółw, 魚, \xF0\x9F\x90\xA2", "zh-Hant-TW"}}) {
            other.title = title;
            other.language = language;
            EXPECT_EQ(wrong_with(pef.encode(other, settings)), "") << title;
        }
        const Page empty = empty_page(settings);
        EXPECT_EQ(wrong_with(pef.encode(empty, settings)), "");
        EXPECT_EQ(wrong_with(pef.encode_pages(std::vector<Page>{other, empty, other}, settings)), "");
    }
}

TEST_F(PefGrammar, RefusesWhatIsNotPef) {
    NEED_TOOL("xmllint");
    const Format& pef = *find_format("pef");
    const Settings settings = with(pef, "8");
    const std::string good = pef.encode(page_of(settings, 0), settings);
    ASSERT_EQ(wrong_with(good), "");
    for (const auto& [part, other] :
         std::vector<std::pair<std::string, std::string>>{{"2008-1", "2008-2"},
                                                          {"cols=\"44\"", "cols=\"0\""},
                                                          {" rowgap=\"0\"", ""},
                                                          {"<dc:format>application/x-pef+xml</dc:format>", ""},
                                                          {"<dc:language>en<", "<dc:language>not a language<"},
                                                          {"<row>", "<row>a"},
                                                          {"<page>", ""},
                                                          {"</pef>", "<images/></pef>"}}) {
        std::string bad = good;
        ASSERT_NE(bad.find(part), std::string::npos) << part;
        bad.replace(bad.find(part), part.size(), other);
        EXPECT_NE(wrong_with(bad), "") << part;
    }
}

std::string from_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned word = 0, bits = 0;
    for (const char c : text.substr(0, text.find('='))) {
        word = word << 6 | static_cast<unsigned>(digits.find(c));
        if (bits += 6; bits >= 8) bytes += static_cast<char>(word >> (bits -= 8) & 0xFFu);
    }
    return bytes;
}

// The dots of the letter U+2800 to U+28FF in UTF-8.
unsigned cell_at(const std::string& text, std::size_t at) {
    return (static_cast<unsigned char>(text[at + 1]) & 3u) << 6 | (static_cast<unsigned char>(text[at + 2]) & 63u);
}

// Where a reader has the dots of rows of cells: 6 mm from cell to cell, 10 mm from row to row, 2.5 mm from dot to dot, centred.
std::vector<Point> dots_of(const std::string& rows) {
    std::vector<Point> dots;
    double y = 0;
    for (std::size_t at = 0; (at = rows.find("<row", at)) != std::string::npos; y += 10) {
        double x = 0;
        for (at += 5; at < rows.size() && rows[at] == '\xE2'; at += 3, x += 6) {
            const unsigned cell = cell_at(rows, at);
            constexpr double kAt[8][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {0, 3}, {1, 3}};
            for (unsigned dot = 0; dot < 8; ++dot)
                if ((cell >> dot & 1u) != 0) dots.push_back({x + 1.75 + 2.5 * kAt[dot][0], y + 1.25 + 2.5 * kAt[dot][1]});
        }
    }
    return dots;
}

TEST_F(PefGrammar, APictureHasTheDotsOfItsRows) {
    const Format& pef = *find_format("pef");
    for (const std::string_view dots : {"6", "8"}) {
        Settings settings = with(pef, dots);
        Page page = page_of(settings, 0), only_words = empty_page(settings);
        only_words.braille = page.braille;
        const std::vector<Page> pages{page, only_words, page_of(settings, 30)};
        const std::string plain = pef.encode_pages(pages, settings);
        settings.set("graphic", "image", "test", "pef");
        const std::string text = pef.encode_pages(pages, settings);
        if (have_tool("xmllint")) {
            EXPECT_EQ(wrong_with(text, "pef-graphics.rng"), "");
            EXPECT_NE(wrong_with(text), "") << "PEF itself has no place for pictures";
            EXPECT_EQ(wrong_with(pef.encode(only_words, settings)), "");
        }
        // Without what is not PEF, it is as it comes, but for its name.
        const std::string name = "tactics-[0-9-]+";
        std::string rest = tests::without(text, " *</?tg:[^>]*>([^<]*</tg:imageData>)?\n");
        rest.replace(rest.find(" xmlns:tg="), std::string(" xmlns:tg=\"http://www.aph.org/ns/tactile-graphics/1.0\"").size(), "");
        EXPECT_TRUE(tests::without(rest, name) == tests::without(plain, name)) << rest;

        const std::vector<tests::Fit> graphics =
            tests::all_fits(text,
                            "<tg:graphic idref=\"(\\w+)\" width=\"(\\d+)\" height=\"(\\d+)\">"
                            "((?:\\s*<row/>|\\s*<row>[^<]*</row>)*)\\s*</tg:graphic>");
        EXPECT_EQ(graphics.size(), 2u);
        for (const tests::Fit& graphic : graphics) {
            const std::string begin = "<tg:imageData id=\"" + graphic[1] + "\" format=\"image/png\" encoding=\"base64\">";
            const auto where = text.find(begin);
            ASSERT_NE(where, std::string::npos);
            const auto first = where + begin.size();
            const Pixels seen = parse_png(from_base64(text.substr(first, text.find('<', first) - first)));
            // A reader makes it as large as fits its cells, which it must fill.
            const double width = 6 * std::stod(graphic[2]), height = 10 * std::stod(graphic[3]);
            const double scale = seen.width / width;
            EXPECT_NEAR(seen.height, height * scale, 1e-9);
            const std::vector<Point> wanted = dots_of(graphic[4]);
            ASSERT_GT(wanted.size(), 50u);
            Pixels expected{seen.width, seen.height, std::vector<std::uint8_t>(seen.black.size())};
            for (const Point dot : wanted)
                for (int y = 0; y < seen.height; ++y) {
                    const double down = (y + 0.5) / scale - dot.y;
                    for (int x = 0; std::abs(down) <= 0.8 && x < seen.width; ++x)
                        if (std::hypot((x + 0.5) / scale - dot.x, down) <= 0.8)
                            expected.black[static_cast<std::size_t>(y) * static_cast<std::size_t>(seen.width) +
                                           static_cast<std::size_t>(x)] = 1;
                }
            EXPECT_EQ(disagreements(seen, expected, 0), 0);
            EXPECT_EQ(seen.count(), expected.count());
        }
        // The title stands above the drawing, as a row of words.
        EXPECT_LT(text.find("<row>\xE2"), text.find("<tg:graphic"));
    }
}

TEST(Ubrl, IsALetterACell) {
    const Format& ubrl = *find_format("ubrl");
    for (const std::string_view dots : {"6", "8"}) {
        const Settings settings = with(ubrl, dots);
        std::string expected;
        for (const std::string& line : unicode_by_machine(dots, 0)) expected += line + "\n";
        EXPECT_EQ(ubrl.encode(page_with(ubrl, settings, 0), settings), expected + "\f");
    }
}

// What cups-filters' imageubrltoindexv4 would make of it: a letter becomes two of the columns of four dots that the machine
// takes.
TEST(Ubrl, OfEqualDistancesIsThePictureOfAnIndex) {
    const Format& ubrl = *find_format("ubrl");
    const Format& index = *find_format("index-v4");
    for (const std::string_view pitch : {"1.6", "2.0", "2.5"}) {
        Settings settings(ubrl.options), of_index(index.options);
        settings.set("pitch", pitch, "test", "ubrl");
        of_index.set("pitch", pitch, "test", "index-v4");
        of_index.set("setup", "no", "test", "index-v4");
        const Page page = page_with(ubrl, settings, 0);
        std::string columns;
        const std::string text = ubrl.encode(page, settings);
        for (std::size_t i = 0; i < text.size() && text[i] != '\f'; i += text[i] == '\n' ? 1 : 3) {
            if (text[i] == '\n') {
                columns.erase(columns.find_last_not_of('@') + 1);
                columns += "\r\n";
                continue;
            }
            const unsigned cell = cell_at(text, i);
            columns += static_cast<char>('@' + ((cell & 7u) | (cell >> 6 & 1u) << 3));
            columns += static_cast<char>('@' + ((cell >> 3 & 7u) | (cell >> 7 & 1u) << 3));
        }
        EXPECT_EQ("\x1b\x07" + columns + "\f\r\x1b\x06\x1a", index.encode(page, of_index)) << pitch;
    }
}

}  // namespace
}  // namespace tactics::pef_test
