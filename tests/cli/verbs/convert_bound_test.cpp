// SPDX-License-Identifier: Apache-2.0
// `tactics convert A B C -o all.pdf`: one file of many pictures.
#include "tests/cli/converting.h"
#include "tests/print/rendered_page.h"

namespace tactics::tests::convert_bound_test {
namespace {

class ConvertBound : public Convert {
protected:
    ConvertBound() {
        write_bytes(folder / "rain.csv", "month,rain (mm)\nJune,80\nJuly,85\n");
        write_bytes(folder / "way.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='80mm' viewBox='0 0 100 80'>"
                    "<path d='M10 10L90 70L10 70Z' fill='none' stroke='black'/></svg>");
    }
    Words all(Words more) const {
        more.insert(more.begin(), {"way.svg", "rain.csv", "disc.tif"});
        return more;
    }
    std::string file(const std::string& name) const { return bytes_of(folder / name); }
    std::string said_by(const std::string& command) const {
        const std::string out = (folder / "said").string();
        const int code = std::system(("cd " + folder.path().string() + " && " + command + " > " + out + " 2>&1").c_str());
        EXPECT_EQ(code, 0) << command << ": " << bytes_of(out);
        std::string text = bytes_of(out);
        std::filesystem::remove(out);
        return text;
    }
};

TEST_F(ConvertBound, EachPageIsThatOfAFileOfItsOwn) {
    NEED_TOOL("pdftoppm");
    const Ending ending = convert(all({"-o", "all.pdf", "-o", "pages/", "--title-from-name"}));
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "all.pdf: 3 pages\n")) << ending.err;
    EXPECT_TRUE(holds(ending.err, "3 of 3 pictures done, 4 files written")) << ending.err;
    int page = 0;
    for (const std::string name : {"way", "rain", "disc"}) {
        ++page;
        const std::string number = std::to_string(page);
        const std::string bound = said_by("pdftoppm -r 40 -mono -f " + number + " -l " + number + " all.pdf");
        EXPECT_EQ(bound, said_by("pdftoppm -r 40 -mono pages/" + name + ".pdf")) << name;
        EXPECT_GT(bound.size(), 1000u);
    }
    EXPECT_TRUE(holds(said_by("pdfinfo all.pdf"), "Tagged:          yes"));
}

TEST_F(ConvertBound, TheOutlineNamesEachPicture) {
    NEED_TOOL("qpdf");
    NEED_TOOL("python3");
    ASSERT_EQ(convert(all({"-o", "all.pdf", "-q"})).code, 0);
    write_bytes(folder / "outline.py",
                "import json, subprocess\n"
                "o = json.loads(subprocess.check_output(['qpdf', '--json=2', 'all.pdf']))\n"
                "pages = [p['object'] for p in o['pages']]\n"
                "for entry in o['outlines']: print(entry['title'], pages.index(entry['dest'][0]) + 1)\n");
    EXPECT_EQ(said_by("python3 outline.py"), "way 1\nrain against row 2\ndisc 3\n");
}

TEST_F(ConvertBound, ThePageThatIsMissingIsNamedAndTheRestIsMade) {
    write_bytes(folder / "bad.png", "no picture");
    const Ending ending = convert({"way.svg", "bad.png", "disc.tif", "-o", "all.pdf"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "all.pdf has no page of bad.png\n")) << ending.err;
    EXPECT_TRUE(holds(ending.err, "all.pdf: 2 pages\n")) << ending.err;
    const Ending none = convert({"bad.png", "bad.png", "-o", "none.pdf"});
    EXPECT_EQ(none.code, 2);
    EXPECT_TRUE(holds(none.err, "none.pdf is not written")) << none.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "none.pdf"));
}

TEST_F(ConvertBound, AnyNumberOfThreadsGivesTheSameBytes) {
    Words words;
    for (int i = 0; i < 12; ++i) {
        const std::string name = "p" + std::to_string(i) + ".csv";
        write_bytes(folder / name, "t,v\n0," + std::to_string(i) + "\n1,5\n");
        words.push_back(name);
    }
    words.insert(words.begin() + 3, "disc.tif");  // slower than the others
    Words one = words, many = words;
    one.insert(one.end(), {"-o", "one.pdf", "-o", "one.brf", "-q", "-j", "1", "--title", "All"});
    many.insert(many.end(), {"-o", "many.pdf", "-o", "many.brf", "-q", "-j", "5", "--title", "All"});
    ASSERT_EQ(convert(one).code, 0);
    ASSERT_EQ(convert(many).code, 0);
    EXPECT_EQ(file("one.pdf"), file("many.pdf"));
    EXPECT_EQ(file("one.brf"), file("many.brf"));
}

TEST_F(ConvertBound, OtherFormatsHoldThemTooIfPagesAreOfOneSize) {
    const Ending ending =
        convert(all({"-o", "all.brf", "-o", "all.tiff", "-o", "all.ps", "-o", "all.pef", "-o", "pages/", "--to", "brf"}));
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "all pages stand upright")) << ending.err;
    std::size_t from = 0;
    for (const std::string name : {"way", "rain", "disc"}) {
        std::string page = file("pages/" + name + ".brf");
        while (!page.empty() && (page.back() == '\f' || page.back() == '\n' || page.back() == '\r')) page.pop_back();
        const auto at = file("all.brf").find(page, from);
        ASSERT_NE(at, std::string::npos) << name;
        from = at + page.size();
    }
    EXPECT_EQ(lines_in(file("all.pef")) > 3, true);
    EXPECT_TRUE(holds(file("all.ps"), "%%Pages: 3"));
    const Ending refused = convert(all({"-o", "all.png"}));
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(holds(refused.err, "png holds one page")) << refused.err;
}

TEST_F(ConvertBound, UpdateMakesAllOrNothing) {
    ASSERT_EQ(convert(all({"-o", "all.pdf"})).code, 0);
    const std::string before = file("all.pdf");
    const Ending none = convert(all({"-o", "all.pdf", "--update"}));
    EXPECT_EQ(none.code, 0);
    EXPECT_TRUE(holds(none.err, "3 were up to date")) << none.err;
    std::filesystem::last_write_time(folder / "way.svg", std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
    const Ending again = convert(all({"-o", "all.pdf", "--update"}));
    EXPECT_TRUE(holds(again.err, "all.pdf: 3 pages")) << again.err;
    EXPECT_EQ(file("all.pdf"), before);
}

TEST_F(ConvertBound, APageThatWasLostOrDamagedIsSeen) {
    const Words update = all({"-o", "all.pdf", "--update"});
    ASSERT_EQ(convert(update).code, 0);
    const std::string whole = file("all.pdf");
    std::filesystem::rename(folder / "disc.tif", folder / "hidden");
    EXPECT_EQ(convert(update).code, 2);
    EXPECT_NE(file("all.pdf"), whole);
    std::filesystem::rename(folder / "hidden", folder / "disc.tif");
    const Ending again = convert(update);
    EXPECT_TRUE(holds(again.err, "all.pdf is not what was written there")) << again.err;
    EXPECT_EQ(file("all.pdf"), whole);
    EXPECT_TRUE(holds(convert(update).err, "3 were up to date"));
}

TEST_F(ConvertBound, AMissingFolderIsToldBeforeTheWork) {
    const Ending ending = convert(all({"-o", "nowhere/all.pdf", "-o", "pages/"}));
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "nowhere/all.pdf: there is no folder nowhere")) << ending.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "pages/way.pdf"));
}

TEST_F(ConvertBound, NothingStandsOnTheBackOfADrawing) {
    const Ending ending = convert({"way.svg", "way.svg", "disc.tif", "-o", "all.pdf", "--duplex", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    for (const std::string page : {"\"page\":1,", "\"page\":3,", "\"page\":5,"})
        EXPECT_TRUE(holds(ending.out, page)) << ending.out;
}

TEST_F(ConvertBound, StandardOutputHoldsOneToo) {
    const Ending ending = convert(all({"-o", "pdf:-", "-q"}));
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(ending.out.substr(0, 5), "%PDF-");
    EXPECT_EQ(convert(all({"-o", "pdf:-", "--json"})).code, 1);
    EXPECT_EQ(convert(all({"-o", "disc.tif"})).code, 1) << "over a picture";
}

}  // namespace
}  // namespace tactics::tests::convert_bound_test
