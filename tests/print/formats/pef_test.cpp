// PEF and Unicode braille: the same cells as an embosser gets, in files that other programs read.
#include <gtest/gtest.h>

#include <regex>

#include "print/embosser.h"
#include "print/format.h"
#include "tests/print/rendered_page.h"

namespace tactics {
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
        const std::string text = pef.encode_pages(std::vector<Page>{page_with(pef, settings, 0), page_with(pef, settings, 30)}, settings);
        std::vector<std::vector<std::string>> pages;
        std::size_t columns = 0, rows = 0;
        const std::regex part("<volume cols=\"(\\d+)\" rows=\"(\\d+)\" rowgap=\"0\" duplex=\"false\">|<page>|<row/>|<row>([^<]*)</row>");
        for (std::sregex_iterator at(text.begin(), text.end(), part), end; at != end; ++at) {
            const std::string found = (*at)[0];
            if (found.starts_with("<volume")) {
                columns = std::stoul((*at)[1]);
                rows = std::stoul((*at)[2]);
            } else if (found == "<page>") {
                pages.emplace_back();
            } else {
                pages.back().push_back((*at)[3]);
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
    const Folder folder;
    const Format& pef = *find_format("pef");
    const Settings settings(pef.options);
    folder.save("page.pef", pef.encode(page_with(pef, settings, 0), settings));
    folder.save("read.py",
                "import sys, xml.etree.ElementTree as tree\n"
                "pef, dc = '{http://www.daisy.org/ns/2008/pef}', '{http://purl.org/dc/elements/1.1/}'\n"
                "root = tree.parse(sys.argv[1]).getroot()\n"
                "meta = root.find(pef + 'head/' + pef + 'meta')\n"
                "print(root.tag == pef + 'pef', root.get('version'), meta.find(dc + 'format').text, bool(meta.find(dc + 'identifier').text),\n"
                "      all(0x2800 <= ord(c) <= 0x28FF for row in root.iter(pef + 'row') for c in row.text or ''))\n");
    EXPECT_EQ(output_of(folder, "python3 " + folder.file("read.py") + " " + folder.file("page.pef")),
              "True 2008-1 application/x-pef+xml True True\n");
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

}  // namespace
}  // namespace tactics
