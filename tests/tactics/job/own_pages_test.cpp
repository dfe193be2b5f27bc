// SPDX-License-Identifier: Apache-2.0
// Our own SVG converted again: the same files, or what is asked for.
#include "tactics/job/own_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/braille/braille.h"
#include "tactics/job/make_pages.h"
#include "tactics/layout/lay_out.h"
#include "tactics/readers/svg/own_page.h"
#include "tests/cli/picture.h"
#include "tests/cli/tool.h"
#include "tests/print/hard_pages.h"

namespace tactics::own_pages_test {
namespace {

class OwnPages : public testing::Test {
protected:
    OwnPages() {
        tests::write_bytes(folder / "discs.tif", tests::grey_picture(240, 180, [](int x, int y) {
                               return std::hypot(x - 80, y - 90) < 60 || std::hypot(x - 190, y - 60) < 25 ? 20 : 220;
                           }));
    }
    Job job(const std::string& input, std::vector<std::string> pages) const {
        Job made{{(folder / input).string(), {}}, {}};
        for (const std::string& page : pages) made.outputs.push_back(output_to((folder / page).string()));
        return made;
    }
    Job german(std::vector<std::string> pages) const {
        Job made = job("discs.tif", std::move(pages));
        made.sheet.title = "Zwei Kreise";
        made.sheet.language = "de";
        made.sheet.braille_table = "de-g1.ctb";
        made.labels = parse_labels("33%,50% Größe\n80%,33% klein\n", "test");
        return made;
    }
    std::string bytes(const std::string& name) const { return tests::bytes_of(folder / name); }
    Page page(const std::string& name) const { return read_own_page(bytes(name), name)->page; }

    tests::Folder folder;
};

TEST_F(OwnPages, AreConvertedIntoTheSameFiles) {
    ASSERT_EQ(make_pages(german({"a.svg", "a.pdf", "a.png", "a.ps"})).error, "");
    const Outcome again = make_pages(job("a.svg", {"b.svg", "b.pdf", "b.png", "b.ps"}));
    ASSERT_EQ(again.error, "");
    for (const std::string ending : {"svg", "pdf", "png", "ps"}) EXPECT_EQ(bytes("a." + ending), bytes("b." + ending)) << ending;
    EXPECT_EQ(again.layouts.front().names.size(), 2u);
}

TEST_F(OwnPages, OfAPdfAreTheSame) {
    ASSERT_EQ(make_pages(german({"a.svg", "a.pdf", "a.png"})).error, "");
    const Outcome again = make_pages(job("a.pdf", {"b.svg", "b.pdf", "b.png"}));
    ASSERT_EQ(again.error, "");
    for (const std::string ending : {"svg", "pdf", "png"}) EXPECT_EQ(bytes("a." + ending), bytes("b." + ending)) << ending;
    ASSERT_EQ(make_pages(job("a.svg", {"c.brf", "c.pef"})).error, "");
    ASSERT_EQ(make_pages(job("a.pdf", {"d.brf", "d.pef"})).error, "");
    for (const std::string ending : {"brf", "pef"}) EXPECT_EQ(bytes("c." + ending), bytes("d." + ending)) << ending;
}

TEST_F(OwnPages, OfAnEmbosserAreConvertedIntoTheSameBraille) {
    Job dots = german({"a.svg", "a.brf", "a.pef", "a.ubrl"});
    dots.sheet.medium = &find_medium("embosser", "test");
    dots.paper = find_paper("11x11.5", "test");
    const Outcome made = make_pages(dots);
    ASSERT_EQ(made.error, "");
    EXPECT_EQ(made.layouts.size(), 1u) << "files of 6-dot cells are of one page";
    ASSERT_EQ(make_pages(job("a.svg", {"b.brf", "b.pef", "b.ubrl", "b.svg"})).error, "");
    for (const std::string ending : {"svg", "brf", "pef", "ubrl"})
        EXPECT_EQ(bytes("a." + ending), bytes("b." + ending)) << ending;
}

// Dots of equal distances are no dots of 6-dot cells, so all files of these have one page of their own.
TEST_F(OwnPages, OfAMachineAreTheSameInAnyFileOfCells) {
    Job machine = german({"a.svg"});
    machine.machine = find_format("index-v4");
    ASSERT_NE(machine.machine, nullptr);
    ASSERT_EQ(make_pages(machine).error, "");
    ASSERT_GT(page("a.svg").bed->raster, 0);
    const Outcome made = make_pages(job("a.svg", {"b.brf", "b.pef", "b.ubrl"}));
    ASSERT_EQ(made.error, "");
    EXPECT_EQ(made.layouts.size(), 1u);
    for (const std::string ending : {"pef", "ubrl"})
        EXPECT_EQ(bytes("b." + ending).find("\xE2\xA1"), std::string::npos) << ending << " has cells with dot 7 or 8";
}

TEST_F(OwnPages, OfTextAreTheSameInAnyFileOfCells) {
    tests::write_bytes(folder / "note.txt",
                       "A note of some words\n\nand one more, which is longer than a line of braille has room for.\n");
    Job text = job("note.txt", {"a.svg"});
    text.as_text = true;
    const Outcome first = make_pages(text);
    ASSERT_EQ(first.error, "");
    const Outcome made = make_pages(job("a.svg", {"b.brf", "b.pef"}));
    ASSERT_EQ(made.error, "");
    const std::vector<BrailleLine> lines = page("a.svg").braille;
    ASSERT_GE(lines.size(), 3u);
    EXPECT_EQ(made.layouts.front().text_lines, first.layouts.front().text_lines);
    EXPECT_FALSE(made.layouts.front().empty);
    const std::string pef = bytes("b.pef");
    std::size_t rows = 0;
    for (std::size_t at = 0; (at = pef.find("<row>", at)) != std::string::npos; ++at) ++rows;
    EXPECT_EQ(rows, lines.size());
}

TEST_F(OwnPages, AnotherMediumHasTheirDrawingAndTheirWords) {
    ASSERT_EQ(make_pages(german({"a.svg"})).error, "");
    Job dots = job("a.svg", {"b.svg"});
    dots.sheet.medium = &find_medium("embosser", "test");
    const Outcome made = make_pages(dots);
    ASSERT_EQ(made.error, "");
    const Page before = page("a.svg"), after = page("b.svg");
    EXPECT_EQ(after.medium, "embosser");
    EXPECT_EQ(after.braille_table, "de-g1.ctb");
    EXPECT_EQ(after.title, "Zwei Kreise");
    ASSERT_EQ(after.names.size(), 2u);
    const auto drawn = [](const Page& one) {
        return std::count_if(one.strokes.begin(), one.strokes.end(),
                             [](const PageStroke& stroke) { return stroke.role == Role::line; });
    };
    EXPECT_EQ(drawn(before), drawn(after));
}

TEST_F(OwnPages, StayAsLargeOnAnotherMedium) {
    const auto widths = [](const Outcome& outcome) {
        std::vector<double> all;
        for (const Layout& layout : outcome.layouts) all.push_back(layout.place.drawing.width);
        return all;
    };
    Job small = german({"a.svg"});
    small.sheet.drawing_width = 120;
    ASSERT_EQ(make_pages(small).error, "");
    const Outcome made = make_pages(job("a.svg", {"b.brf", "b.pef", "b.height.png"}));
    ASSERT_EQ(made.error, "");
    ASSERT_GE(made.layouts.size(), 2u);
    for (const double width : widths(made)) EXPECT_NEAR(width, 120, 0.05);
    // Where there is no room for that it is as large as there is, and a person hears of it.
    Job large = german({"c.svg"});
    large.paper = find_paper("a3", "test");
    ASSERT_EQ(make_pages(large).error, "");
    const Outcome smaller = make_pages(job("c.svg", {"d.brf"}));
    ASSERT_EQ(smaller.error, "");
    EXPECT_LT(widths(smaller).front(), page("c.svg").drawing.width - 10);
    EXPECT_GT(widths(smaller).front(), 200);
    const auto told = [](const Outcome& outcome) {
        return std::count_if(outcome.notes.begin(), outcome.notes.end(), [](const Note& note) {
            return note.asks() && note.english().find("room for no more") != std::string::npos;
        });
    };
    EXPECT_EQ(told(smaller), 1);
    EXPECT_EQ(told(made), 0);
    // A width, sheets that are laid together, or more paper of the same medium: another size is asked for.
    Job wide = job("a.svg", {"e.brf"});
    wide.sheet.drawing_width = 200;
    const Outcome wider = make_pages(wide);
    ASSERT_EQ(wider.error, "");
    EXPECT_NEAR(widths(wider).front(), 200, 0.05);
}

TEST_F(OwnPages, GiveWayToWhatIsAskedFor) {
    ASSERT_EQ(make_pages(german({"a.svg"})).error, "");
    Job titled = job("a.svg", {"b.svg"});
    titled.sheet.title = "Ein Titel";
    ASSERT_EQ(make_pages(titled).error, "");
    EXPECT_EQ(page("b.svg").title, "Ein Titel");
    EXPECT_EQ(page("b.svg").language, "de");
    EXPECT_EQ(page("b.svg").width, page("a.svg").width);
    Job larger = job("a.svg", {"c.svg"});
    larger.paper = find_paper("a3", "test");
    ASSERT_EQ(make_pages(larger).error, "");
    EXPECT_GT(page("c.svg").drawing.width, 1.3 * page("a.svg").drawing.width);
    Job same = job("a.svg", {"d.svg"});
    same.paper = find_paper("a4", "test");
    ASSERT_EQ(make_pages(same).error, "");
    EXPECT_EQ(bytes("d.svg"), bytes("a.svg"));
}

TEST(PagesOfOwn, TheKeyComesBehindItsDrawing) {
    Drawing drawing;
    drawing.width = 100;
    drawing.height = 130;
    for (int row = 0; row < 9; ++row) drawing.strokes.push_back({{{0, row * 16.0}, {100, row * 16.0}}, false, LineClass::normal});
    for (int i = 0; i < 8; ++i)
        drawing.names.push_back(
            {{50, 8 + 16.0 * i}, "Number " + std::to_string(i) + ", with far more words than a line has room for", "n"});
    const Pages pages = pages_of(drawing, rendered::sheet_of("a5", "Keys"));
    ASSERT_GT(pages.all.size(), 1u) << "its key has no room on the page";
    const Format& pdf = *find_format("pdf");
    const auto file = [&](const std::vector<Page>& all) {
        std::string bytes;
        each_file(pdf, all, Settings(pdf.options), [&](std::string_view more) { bytes += more; });
        return bytes;
    };
    const Format& svg = *find_format("svg");
    const Page again = read_own_page(svg.encode(pages.all.front(), Settings(svg.options)), "a.svg")->page;
    EXPECT_EQ(file(pages_of_own(again, {}).all), file(pages.all));
    const Page key = read_own_page(svg.encode(pages.all.back(), Settings(svg.options)), "b.svg")->page;
    EXPECT_EQ(pages_of_own(key, {}).all.size(), 1u);
}

}  // namespace
}  // namespace tactics::own_pages_test
