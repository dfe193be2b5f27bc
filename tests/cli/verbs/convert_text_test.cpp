// SPDX-License-Identifier: Apache-2.0
// Text and pages of PDF through the program: text as braille, figures as their own lines and words.
#include "tests/cli/converting.h"
#include "tests/cli/pdf_files.h"

namespace tactics::convert_text_test {
namespace {

using namespace tests;

class ConvertText : public Convert {
protected:
    void SetUp() override {
        if (!has_tool("pdftotext")) GTEST_SKIP() << "poppler-utils is missing";
    }
    std::string brf(const std::string& input, Words more = {}) {
        more.insert(more.begin(), {input, "--text", "-q", "-o", "brf:-", "--braille", "en-us-comp6.ctb"});
        std::string text = convert(more).out;
        std::erase_if(text, [](char c) { return c == '\r' || c == '_'; });
        return text;
    }
};

std::string line_of_text(double x, double y, const std::string& words, double size = 12) {
    return "BT /F " + std::to_string(size) + " Tf " + std::to_string(x) + " " + std::to_string(y) + " Td (" + words + ") Tj ET ";
}

const std::string kFigure = "2 w 60 60 280 180 re S [6 4] 0 d 60 60 m 340 240 l S " + line_of_text(160, 270, "Speed of a car") +
                            line_of_text(180, 20, "time \\(s\\)") + line_of_text(40, 60, "0") + line_of_text(40, 235, "20");

TEST_F(ConvertText, APageOfAPdfKeepsItsLinesAndItsWords) {
    write_bytes(folder / "figure.pdf", pdf_page(kFigure));
    const Ending made = convert({"figure.pdf", "-o", "page.svg", "--json"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(holds(made.out, "\"format\":\"SVG\"")) << made.out;  // no recipe, no reading of print
    const std::string page = run_tactics(folder, {"describe", "page.svg"}).out;
    for (const char* word : {"Speed of a car", "\"time (s)\"", "\"20\"", "\"0\"", "rectangle", "dashed"})
        EXPECT_TRUE(holds(page, word)) << page;
    // In pixels if filters are asked for.
    EXPECT_TRUE(holds(convert({"figure.pdf", "-o", "b.svg", "--recipe", "line-art", "--json"}).out, "\"recipe\":\"line-art\""));
}

TEST_F(ConvertText, APageOfTextIsRefusedWithTheWayOutAndLaidOutIfAsked) {
    std::string content;
    for (int i = 0; i < 12; ++i) content += line_of_text(40, 270 - 16 * i, "these are nine words of a page of text");
    write_bytes(folder / "text.pdf", pdf_page(content));
    const Ending refused = convert({"text.pdf", "-o", "page.svg"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(holds(refused.err, "page 1 is text, 108 words, and would be felt as rubble; lay it out in braille with --text"))
        << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "page.svg"));
    const std::string text = brf("text.pdf");
    std::size_t words = 0;
    for (auto at = text.find("WORDS"); at != text.npos; at = text.find("WORDS", at + 1)) ++words;
    EXPECT_EQ(words, 12u) << text;
    EXPECT_TRUE(holds(convert({"text.pdf", "--text", "-o", "a.brf", "-o", "a.pdf"}).err, " lines of braille"));
}

TEST_F(ConvertText, ATextFileHasItsParagraphsAndHeadings) {
    write_bytes(folder / "notes.txt",
                "# maps\r\n\r\nfirst line\r\nof the text exam-\r\nple\n\nsecond one\n- item\n- other\n\nend\n===\n");
    const std::string text = brf("notes.txt");
    EXPECT_TRUE(holds(text, "\n\n  FIRST LINE OF THE TEXT EXAM-PLE\n  SECOND ONE\n  - ITEM\n  - OTHER\n\n")) << text;
    EXPECT_TRUE(holds(text, "        MAPS\n")) << text;
    EXPECT_TRUE(holds(text, "        END\n")) << text;
}

TEST_F(ConvertText, TellsPagesAndDrawingsThatItLeavesOut) {
    const std::string words = line_of_text(40, 200, "these are words"),
                      pixels = "q 200 0 0 200 60 60 cm BI /W 1 /H 1 /CS /G /BPC 8 ID \x80 EI Q ";
    write_bytes(folder / "mixed.pdf", pdf_pages({words, pixels, words + "2 w 60 60 280 100 re S ", words + pixels, ""}));
    const std::string told = convert({"mixed.pdf", "--text", "-o", "a.brf"}).err;
    EXPECT_TRUE(holds(told, "page 2 has no words and is left out; it may be a scan, have it read first: ocrmypdf")) << told;
    EXPECT_TRUE(holds(told, "pages 3, 4 have drawings or pictures besides their words, which are left out")) << told;
    write_bytes(folder / "plain.pdf", pdf_pages(std::vector<std::string>(120, words)));
    EXPECT_EQ(lines_in(convert({"plain.pdf", "--text", "-o", "a.brf"}).err), 1u);
    std::vector<std::string> many(120, words);
    many[98] += "2 w 60 60 280 100 re S ";
    write_bytes(folder / "many.pdf", pdf_pages(many));
    const std::string one = convert({"many.pdf", "--text", "-o", "a.brf"}).err;
    EXPECT_TRUE(holds(one, "page 99 has drawings")) << one;
    EXPECT_TRUE(holds(one, "120 lines of braille")) << one;
    EXPECT_TRUE(
        holds(convert({"many.pdf", "--text", "--page", "121", "-o", "a.brf"}).err, "there is no page 121, but pages 1 to 120"));
}

// A page whose font says that \001 is a soft hyphen, as typesetting programs write it, and that \002 is no letter.
std::string pdf_with_own_letters(const std::string& content) {
    const std::string map =
        "/CIDInit /ProcSet findresource begin begincmap /CMapName /M def 1 begincodespacerange <00> <FF> endcodespacerange "
        "3 beginbfchar <01> <00AD> <02> <0001> <20> <0020> endbfchar 1 beginbfrange <61> <7A> <0061> endbfrange endcmap end";
    std::string widths;
    for (int letter = 1; letter <= 'z'; ++letter) widths += "500 ";
    return pdf_of(
        {"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [4 0 R] /Count 1 >>", "<< >>",
         "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 400 300] /Contents 5 0 R /Resources << /Font << /F << /Type /Font "
         "/Subtype /Type1 /BaseFont /Helvetica /ToUnicode 6 0 R /FirstChar 1 /LastChar 122 /Widths [" +
             widths + "] /Encoding << /Differences [1 /hyphen /bullet] >> >> >> >> >>",
         stream_of("", "BT /F 12 Tf 14 TL 40 200 Td " + content + " ET"), stream_of("", map)});
}

TEST_F(ConvertText, SoftHyphensOfAPdfGo) {
    write_bytes(folder / "soft.pdf", pdf_with_own_letters("(this is a soft exam\\001) Tj T* (ple of text) Tj"));
    EXPECT_TRUE(holds(brf("soft.pdf"), "THIS IS A SOFT EXAMPLE OF TEXT")) << brf("soft.pdf");
    EXPECT_FALSE(holds(convert({"soft.pdf", "--text", "-o", "a.brf"}).err, "hyphen"));  // it is no guess
}

TEST_F(ConvertText, LettersOfAFontThatTellsNoneAreFullCells) {
    write_bytes(folder / "odd.pdf", pdf_with_own_letters("(some good\\002 words) Tj"));
    EXPECT_TRUE(holds(brf("odd.pdf"), "SOME GOOD= WORDS")) << brf("odd.pdf");
    EXPECT_TRUE(holds(convert({"odd.pdf", "--text", "-o", "a.brf"}).err, "the braille table has no cells for"));
}

TEST_F(ConvertText, SaysWhatCannotBeText) {
    write_bytes(folder / "latin.txt", "caf\xE9\n");
    write_bytes(folder / "empty.txt", " \n\n");
    write_bytes(folder / "figure.pdf", pdf_page("2 w 60 60 280 180 re S"));
    write_bytes(folder / "notes.txt", "some words\n");
    write_bytes(folder / "figure.svg",
                "<?xml version='1.0'?>\n<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0 L9 9'/></svg>");
    write_bytes(folder / "page.html", "<!DOCTYPE HTML><title>a page</title>");
    write_bytes(folder / "chat.txt", "<me> hello\n");
    const auto told = [&](const Words& words, const std::string& what, int code) {
        const Ending ending = convert(words);
        EXPECT_EQ(ending.code, code) << ending.err;
        EXPECT_TRUE(holds(ending.err, what)) << ending.err;
    };
    told({"latin.txt", "--text", "-o", "a.brf"}, "latin.txt: it is no text in UTF-8; save it as UTF-8", 2);
    told({"disc.tif", "--text", "-o", "a.brf"}, "disc.tif: it is a picture, no text; leave out --text", 2);
    told({"figure.svg", "--text", "-o", "a.brf"}, "figure.svg: it is a figure in SVG, no text; leave out --text", 2);
    told({"page.html", "--text", "-o", "a.brf"}, "page.html: it is an HTML page; save it as text", 2);
    EXPECT_TRUE(holds(brf("chat.txt"), "ME"));
    EXPECT_FALSE(holds(convert({"empty.txt", "--text", "-o", "a.brf"}).err, "ocrmypdf"));
    write_bytes(folder / "large.txt", std::string(4'000'001, 'a'));
    told({"large.txt", "--text", "-o", "a.brf"}, "large.txt: this text has over 4 MB; cut it into parts", 2);
    told({"empty.txt", "--text", "-o", "a.brf"}, "nothing is written in it", 2);
    told({"figure.pdf", "--text", "-o", "a.brf"}, "nothing is written in it", 2);
    told({"notes.txt", "--text", "--page", "2", "-o", "a.brf"}, "--page: notes.txt is no PDF", 1);
    told({"notes.txt", "--text", "--recipe", "photo", "-o", "a.brf"}, "--recipe: it is about drawings, and --text makes none", 1);
    told({"notes.txt", "--text", "--braille", "none", "-o", "a.brf"}, "text is laid out in braille", 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.brf"));
}

TEST_F(ConvertText, SeveralPagesOfAPdfAreConvertedAtOnce) {
    std::vector<std::string> objects = {"<< /Type /Catalog /Pages 2 0 R >>",
                                        "<< /Type /Pages /Kids [4 0 R 6 0 R 8 0 R] /Count 3 >>", "<< >>"};
    for (int page = 0; page < 3; ++page) {
        objects.push_back("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 400 300] /Contents " + std::to_string(5 + 2 * page) +
                          " 0 R >>");
        objects.push_back(stream_of("", "2 w 60 60 " + std::to_string(100 + 80 * page) + " 180 re S"));
    }
    write_bytes(folder / "three.pdf", pdf_of(objects));
    const Ending made = convert({"three.pdf", "--page", "3,1-2", "-o", "pages/", "-t", "svg", "--json"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(names("pages"), "three-page1.svg three-page2.svg three-page3.svg");
    EXPECT_TRUE(holds(made.out, "\"pdf_page\":3")) << made.out;
    for (const char* page : {"1", "2", "3"}) {
        ASSERT_EQ(convert({"three.pdf", "--page", page, "-q", "-o", "alone.svg"}).code, 0);
        EXPECT_EQ(bytes_of(folder / "alone.svg"), bytes_of(folder / ("pages/three-page" + std::string(page) + ".svg"))) << page;
    }
    EXPECT_NE(run_tactics(folder, {"describe", "three.pdf", "--page", "3"}).out,
              run_tactics(folder, {"describe", "three.pdf"}).out);
    const auto refused = [&](const Words& words, const std::string& what, int code) {
        const Ending ending = run_tactics(folder, words);
        EXPECT_EQ(ending.code, code) << ending.err;
        EXPECT_TRUE(holds(ending.err, what)) << ending.err;
    };
    refused({"convert", "three.pdf", "--page", "1-2", "-o", "a.png"}, "png holds one page, and there are several pages of a PDF",
            1);
    for (const char* list : {"0", "2-1", "1,", "1-", "x", "1.5", "1-2000000"})
        refused({"convert", "three.pdf", "--page", list, "-o", "pages/"},
                "--page: it is the number of a page, from 1, or several such as 1-3,7", 1);
    refused({"convert", "three.pdf", "--page", "1-10001", "-o", "pages/"}, "these are over 10,000 pages", 1);
    refused({"convert", "three.pdf", "--page", "3-4", "-q", "-o", "pages/"}, "there is no page 4, but pages 1 to 3", 2);
    refused({"check", "three.pdf", "--page", "4"}, "there is no page 4, but pages 1 to 3", 1);
    EXPECT_NE(run_tactics(folder, {"check", "three.pdf", "--page", "3", "--json"}).out,
              run_tactics(folder, {"check", "three.pdf", "--json"}).out);
}

TEST_F(ConvertText, ALockedPdfIsToldAsOne) {
    write_bytes(folder / "locked.pdf",
                "%PDF-1.4\n1 0 obj\n<< /Type /Catalog >>\nendobj\ntrailer << /Root 1 0 R /Encrypt 2 0 R >>\n%%EOF\n");
    EXPECT_TRUE(
        holds(convert({"locked.pdf", "-o", "a.svg"}).err, "locked.pdf: this PDF is locked with a password; take that off first"));
}

}  // namespace
}  // namespace tactics::convert_text_test
