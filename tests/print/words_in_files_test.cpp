// SPDX-License-Identifier: Apache-2.0
// The description within PDF and SVG: other programs read it back, and what is drawn stays as it was.
#include <sstream>

#include "tactics/description/description.h"
#include "tactics/layout/lay_out.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::words_in_files_test {
namespace {

using namespace rendered;

Page described_page(const std::string& title = "Größe & <more>") { return lay_out(hard_drawing(), sheet_of("a5", title)); }

std::string without_tags(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
        const std::string line = text.substr(at, end - at);
        if (!line.ends_with("BDC") && !line.ends_with("BMC") && !line.ends_with("EMC")) out += line + "\n";
        at = end + 1;
    }
    return out;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(WordsInFiles, PdfGivesItsAlternativeTextAndLanguagesBack) {
    NEED_TOOL("qpdf");
    NEED_TOOL("python3");
    const FileFolder folder;
    Sheet sheet = sheet_of("a5", "Ballon");
    sheet.language = "fr-CA";
    const std::string script = folder.save(
        "alt.py",
        "import json, subprocess, sys\n"
        "objects = json.loads(subprocess.check_output(['qpdf', '--json=2', sys.argv[1]]))['qpdf'][1].values()\n"
        "values = [o['value'] for o in objects if 'value' in o]\n"
        "elements = [v for v in values if isinstance(v, dict) and v.get('/Type') == '/StructElem']\n"
        "figures = [e for e in elements if e['/S'] == '/Figure']\n"
        "print([e['/ActualText'][2:] for e in elements if '/ActualText' in e])\n"
        "root = [v for v in values if isinstance(v, dict) and v.get('/Type') == '/Catalog'][0]\n"
        "print(len(figures), figures[0]['/Alt'][2:], figures[0]['/Lang'], root['/Lang'], root['/MarkInfo']['/Marked'])\n");
    for (const bool print_title : {true, false}) {
        sheet.print_title = print_title;  // without it the braille is told as braille
        const Page page = lay_out(hard_drawing(), sheet);
        EXPECT_EQ(output_of(folder, "python3 " + script + " " + folder.save("page.pdf", encode(page, "pdf"))),
                  std::string(print_title ? "[]" : "['\u2820\u2803\u2801\u2807\u2807\u2815\u281d']") + "\n1 " +
                      alternative_text(page, describe(page)) + " u:fr u:fr-CA True\n");
    }
}

TEST(WordsInFiles, PdfIsTaggedInReadingOrder) {
    NEED_TOOL("pdfinfo");
    const FileFolder folder;
    const auto structure = [&](const Sheet& sheet) {
        return output_of(folder,
                         "pdfinfo -struct-text " + folder.save("page.pdf", encode(lay_out(hard_drawing(), sheet), "pdf")));
    };
    EXPECT_NE(
        output_of(folder, "pdfinfo " + folder.save("page.pdf", encode(described_page(), "pdf"))).find("Tagged:          yes"),
        std::string::npos);
    const Sheet sheet = sheet_of("a5", "A title");
    EXPECT_TRUE(structure(sheet).starts_with("Document\n  H1 (block)\n    \"A title\"\n  Figure")) << structure(sheet);
}

// The twin without its tags is drawn pixel by pixel the same.
TEST(WordsInFiles, TagsDrawNothing) {
    NEED_TOOL("qpdf");
    NEED_TOOL("fix-qdf");
    NEED_TOOL("gs");
    const FileFolder folder;
    for (const Page& page : {described_page(), lay_out(picture_drawing(60, 40), sheet_of("100x80mm", "Dots"))}) {
        const std::string pdf = encode(page, "pdf");
        const std::string in = folder.save("tagged.pdf", pdf), open = folder.file("open.pdf");
        ASSERT_EQ(output_of(folder, "qpdf --qdf --object-streams=disable " + in + " " + open), "");
        const std::string bare = without_tags(read_file(open));
        ASSERT_LT(bare.size(), read_file(open).size());
        ASSERT_EQ(std::system(("fix-qdf " + folder.save("bare.pdf", bare) + " >" + folder.file("fixed.pdf")).c_str()), 0);
        EXPECT_EQ(by_ghostscript(folder, pdf, 150).black, by_ghostscript(folder, read_file(folder.file("fixed.pdf")), 150).black);
    }
}

// Tags cost the same for any drawing.
TEST(WordsInFiles, TheNumberOfTagsDoesNotGrowWithTheDrawing) {
    NEED_TOOL("qpdf");
    const FileFolder folder;
    const auto tags = [&](int strokes) {
        Drawing drawing;
        drawing.width = drawing.height = 100;
        for (int i = 0; i < strokes; ++i)
            drawing.strokes.push_back({{{5, i * 0.1}, {95, i * 0.15}}, false, LineClass::normal, 0});
        const std::string in = folder.save("page.pdf", encode(lay_out(drawing, sheet_of("a4", "Lines")), "pdf"));
        EXPECT_EQ(output_of(folder, "qpdf --qdf " + in + " " + folder.file("open.pdf")), "");
        return count_of(read_file(folder.file("open.pdf")), "EMC\n");
    };
    EXPECT_EQ(tags(5), tags(500));
}

TEST(WordsInFiles, SvgIsWellFormedAndSaysTheSame) {
    NEED_TOOL("python3");
    const FileFolder folder;
    const Page page = described_page();
    const std::string script = folder.save(
        "desc.py",
        "import sys, xml.etree.ElementTree as tree\n"
        "root = tree.parse(sys.argv[1]).getroot()\n"
        "svg, lang = '{http://www.w3.org/2000/svg}', '{http://www.w3.org/XML/1998/namespace}lang'\n"
        "ids = [e.get('id') for e in root.iter() if e.get('id')]\n"
        "assert len(ids) == len(set(ids)), ids\n"
        "for e in root.iter():\n"
        "    assert all(name in ids for name in e.get('aria-labelledby', '').split()), e.attrib\n"
        "things = [g.find(svg + 'title').text for g in root.iter(svg + 'g') if g.get('id', '').startswith('thing-')]\n"
        "assert len(things) == int(sys.argv[2]) and all('. ' in t for t in things), things\n"
        "print(root.find(svg + 'title').text, root.get(lang), root.find(svg + 'desc').get(lang), root.find(svg + "
        "'desc').text)\n");
    const Description description = describe(page);
    EXPECT_EQ(output_of(folder, "python3 " + script + " " + folder.save("page.svg", encode(page, "svg")) + " " +
                                    std::to_string(description.things.size())),
              page.title + " en en " + alternative_text(page, description) + "\n");
}

TEST(WordsInFiles, SvgIsDrawnAsWithoutItsWords) {
    NEED_TOOL("rsvg-convert");
    const FileFolder folder;
    const std::string svg = encode(described_page(), "svg");
    // Around one path each.
    std::string bare, line;
    std::istringstream lines(svg);
    for (int groups = 0; std::getline(lines, line);) {
        if (line.starts_with("<g id=\"thing-")) {
            ++groups;
        } else if (line == "</g>" && groups > 0) {
            --groups;
        } else {
            bare += line + "\n";
        }
    }
    ASSERT_EQ(bare.find("thing-"), std::string::npos);
    ASSERT_LT(bare.size(), svg.size());
    EXPECT_EQ(by_librsvg(folder, svg, 150).black, by_librsvg(folder, bare, 150).black);
}

TEST(WordsInFiles, HostileWordsAreHarmless) {
    NEED_TOOL("qpdf");
    NEED_TOOL("rsvg-convert");
    const FileFolder folder;
    Sheet sheet = sheet_of("a5");
    sheet.braille_table.clear();
    sheet.description = "</desc><script>) >> endobj \\( \xff\xfe \x01 \xe2\x80\xae ]]>&amp;\"";
    sheet.language = "en) /Evil (\"><x";
    const Page page = lay_out(hard_drawing(), sheet);
    int code = 0;
    const std::string said = output_of(folder, "qpdf --check " + folder.save("page.pdf", encode(page, "pdf")), &code);
    EXPECT_EQ(code, 0) << said;
    EXPECT_GT(by_librsvg(folder, encode(page, "svg"), 50).count(), 100);
    EXPECT_EQ(encode(page, "svg").find("<script"), std::string::npos);
}

TEST(WordsInFiles, TextIsTheDescriptionLineByLine) {
    const Page page = described_page();
    std::string expected;
    for (const auto& line : lines_of(describe(page))) expected += line + "\n";
    EXPECT_EQ(encode(page, "text"), expected);
}

}  // namespace
}  // namespace tactics::words_in_files_test
