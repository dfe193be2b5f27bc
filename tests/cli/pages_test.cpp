// SPDX-License-Identifier: Apache-2.0
// Several pages of one picture, as the user meets them.
#include <fstream>

#include "tactics/layout/lay_out.h"
#include "tests/cli/converting.h"
#include "tests/patterns.h"

namespace tactics::tests::pages_test {
namespace {

// Words that are wider than any page, so that they go to the key, and the key to page 2.
const std::string kLabel = "30%,40%=The old road from the station to the river that was closed when the new bridge was built";

class Pages : public Convert {};

TEST_F(Pages, AFileThatHoldsOnePageGetsOthersBesideIt) {
    const Ending ending = convert({"disc.tif", "-o", "out/", "-o", "map.pdf", "-o", "a.b/map.HEIGHT.PNG", "-o", "svg:plan", "-t",
                                   "png", "--paper", "a5", "--label", kLabel});
    EXPECT_EQ(ending.code, 2);  // no folder a.b, so nothing is written
    EXPECT_EQ(names(), "disc.tif");
    std::filesystem::create_directory(folder / "a.b");
    const Ending done = convert({"disc.tif", "-o", "out/", "-o", "map.pdf", "-o", "a.b/map.HEIGHT.PNG", "-o", "svg:plan", "-t",
                                 "png", "--paper", "a5", "--label", kLabel});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(names(), "a.b disc.tif map.pdf out plan plan-2");
    EXPECT_EQ(names("out"), "disc-2.png disc.png");
    EXPECT_EQ(names("a.b"), "map-2.HEIGHT.PNG map.HEIGHT.PNG");
    EXPECT_TRUE(holds(
        done.err,
        "disc.tif: out/disc.png, out/disc-2.png, map.pdf, a.b/map.HEIGHT.PNG, a.b/map-2.HEIGHT.PNG, plan, plan-2: 2 pages, "))
        << done.err;
    EXPECT_TRUE(holds(bytes_of(folder / "map.pdf"), "/Count 2 "));
    EXPECT_TRUE(holds(bytes_of(folder / "plan-2"), "On it is the key"));
    EXPECT_FALSE(holds(bytes_of(folder / "plan"), "On it is the key"));
}

TEST_F(Pages, JsonTellsWhatIsWhere) {
    const Ending ending = convert({"disc.tif", "-o", "map.svg", "-o", "map.pdf", "--json", "--label", kLabel});
    EXPECT_TRUE(holds(ending.out, "\"path\": \"map.svg\"") || holds(ending.out, "\"path\":\"map.svg\"")) << ending.out;
    std::string tight = ending.out;
    std::erase(tight, ' ');
    const auto told = [&](const std::string& path, const std::string& format, const std::string& pages) {
        const std::string bytes = std::to_string(std::filesystem::file_size(folder / path));
        return holds(tight, "{\"path\":\"" + path + "\",\"format\":\"" + format + "\",\"bytes\":" + bytes + "," + pages);
    };
    EXPECT_TRUE(told("map.svg", "svg", "\"page\":1,\"pages\":1,")) << tight;
    EXPECT_TRUE(told("map-2.svg", "svg", "\"page\":2,\"pages\":1,")) << tight;
    EXPECT_TRUE(told("map.pdf", "pdf", "\"page\":1,\"pages\":2,")) << tight;
}

TEST_F(Pages, StandardOutputHoldsOneFile) {
    const Ending ending = convert({"disc.tif", "-o", "png:-", "--label", kLabel});
    EXPECT_EQ(ending.code, 1);
    EXPECT_EQ(ending.out, "");
    EXPECT_TRUE(
        holds(ending.err, "there are 2 pages, and png holds one; write to a file, which gets others beside it, or choose pdf"))
        << ending.err;
    EXPECT_TRUE(holds(convert({"disc.tif", "-q", "-o", "pdf:-", "--label", kLabel}).out, "/Count 2 "));
}

TEST_F(Pages, NoFurtherPageGoesOverAPictureOrAnotherPage) {
    write_bytes(folder / "map.tif", disc_picture());
    write_bytes(folder / "map-2.tif", disc_picture());
    const Ending taken = convert({"map.tif", "map-2.tif", "-o", "out/", "-t", "svg", "--label", kLabel});
    EXPECT_EQ(taken.code, 2);
    EXPECT_TRUE(
        holds(taken.err, "map.tif: out/map-2.svg: page 2 of out/map.svg would be written here, over a picture or another page"))
        << taken.err;
    EXPECT_EQ(names("out"), "map-2-2.svg map-2.svg");
    // Nor where that page is there already.
    EXPECT_EQ(convert({"map.tif", "map-2.tif", "-o", "out/", "-t", "svg", "--label", kLabel}).code, 2);
    EXPECT_EQ(names("out"), "map-2-2.svg map-2.svg");
    EXPECT_EQ(convert({"map.tif", "map-2.tif", "-o", "out/", "-t", "pdf", "--label", kLabel}).code, 0);
}

TEST_F(Pages, UpdateLeavesThemAloneUntilSomethingChanges) {
    const Words words{"disc.tif", "-o", "out/", "-t", "svg", "--update", "--label", kLabel};
    EXPECT_EQ(convert(words).code, 0);
    EXPECT_TRUE(holds(convert(words).err, "up to date"));
    std::filesystem::remove(folder / "out" / "disc.svg");
    EXPECT_FALSE(holds(convert(words).err, "up to date"));
    EXPECT_EQ(names("out"), "disc-2.svg disc.svg");
}

TEST_F(Pages, BindingIsRead) {
    const auto box = [&](const Words& more) {
        Words words{"disc.tif", "-o", "page.svg", "-q", "--width", "80mm", "--paper", "a5", "--orientation", "portrait"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(convert(words).code, 0);
        return bytes_of(folder / "page.svg");
    };
    EXPECT_NE(box({"--binding", "left=15mm"}), box({}));
    EXPECT_NE(box({"--binding", "left=15mm"}), box({"--binding", "right=15mm"}));
    EXPECT_EQ(box({"--binding", "left=0mm"}), box({}));
    EXPECT_EQ(box({"--binding", "top=1.5cm"}), box({"--binding", "top=15mm", "--duplex"}));
    for (const std::string wrong : {"15mm", "left", "left=", "left=-1mm", "bottom=3mm", "=3mm", "left=x"}) {
        const Ending ending = convert({"disc.tif", "-o", "page.svg", "--binding", wrong});
        EXPECT_EQ(ending.code, 1) << wrong;
        EXPECT_TRUE(
            holds(ending.err, "tactics: --binding: it cannot be \"" + wrong + "\"; it is left, top or right with a length"))
            << ending.err;
    }
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "page.svg", "--bare", "--binding", "left=3mm"}).err,
                      "--bare: the drawing alone is not bound"));
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "page.svg", "--binding", "left=300mm"}).err,
                      "--binding: 300 mm for the binding leaves nothing of "));
}

TEST_F(Pages, TilesAreSheetsOfOneLargePage) {
    const Ending ending = convert({"disc.tif", "-o", "map.pdf", "-o", "map.png", "--tiles", "2x3", "--paper", "a4", "--json"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(names(), "disc.tif map-2.png map-3.png map-4.png map-5.png map-6.png map.pdf map.png");
    EXPECT_TRUE(holds(bytes_of(folder / "map.pdf"), "/Count 6 "));
    // The large page is described, not its pieces.
    const std::string words = run_tactics(folder, {"describe", "disc.tif", "--tiles", "2x2"}).out;
    EXPECT_TRUE(words.starts_with("Page: ")) << words;
    EXPECT_EQ(words.rfind("Page: "), 0u) << words;
    for (const std::string wrong : {"", "2", "2x", "0x2", "2x10", "2 x 2", "axb", "2x2x2"})
        EXPECT_TRUE(holds(convert({"disc.tif", "-o", "map.pdf", "--tiles", wrong}).err,
                          "tactics: --tiles: it cannot be \"" + wrong + "\"; it is columns x rows"))
            << wrong;
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "a.pdf", "--bare", "--tiles", "2x2"}).err,
                      "--bare: the drawing alone is not cut into sheets"));
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "a.pdf", "--braille", "none", "--label", "1%,1%=x", "--tiles", "2x2"}).err,
                      "--tiles: labels in print would be cut"));
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "a.pdf", "--paper", "60x60mm", "--tiles", "2x2"}).err,
                      "--tiles: 60 mm x 60 mm paper is too small to be laid together"));
}

TEST_F(Pages, DescribeSaysThemAll) {
    const Ending ending = run_tactics(folder, {"describe", "disc.tif", "--label", kLabel});
    EXPECT_TRUE(holds(ending.out, "\n\nTitle: Key.\nPage: ")) << ending.out;
    EXPECT_TRUE(holds(ending.out, "On it is the key to the drawing: ")) << ending.out;
    EXPECT_TRUE(holds(run_tactics(folder, {"describe", "--json", "disc.tif", "--label", kLabel}).out,
                      "On it is the key to the drawing: "));
}

TEST_F(Pages, UpdateSeesAPageThatIsGone) {
    const Words tiles{"disc.tif", "-o", "out/", "-t", "png", "--update", "--tiles", "2x1"};
    EXPECT_EQ(convert(tiles).code, 0);
    EXPECT_TRUE(holds(convert(tiles).err, "up to date"));
    std::filesystem::remove(folder / "out" / "disc-2.png");
    EXPECT_FALSE(holds(convert(tiles).err, "up to date"));
    EXPECT_EQ(names("out"), "disc-2.png disc.png");
    const Words key{"disc.tif", "-o", "key/", "-t", "svg", "--update", "--label", kLabel};
    EXPECT_EQ(convert(key).code, 0);
    EXPECT_TRUE(holds(convert(key).err, "up to date"));
    std::filesystem::remove(folder / "key" / "disc-2.svg");
    EXPECT_FALSE(holds(convert(key).err, "up to date"));
    EXPECT_EQ(names("key"), "disc-2.svg disc.svg");
}

// It may be somebody's own, so it is told and left.
TEST_F(Pages, AFileLeftOfAnEarlierRunIsTold) {
    EXPECT_EQ(convert({"disc.tif", "-o", "map.svg", "--label", kLabel}).code, 0);
    const Ending ending = convert({"disc.tif", "-o", "map.svg"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_TRUE(
        holds(ending.err, "disc.tif: map-2.svg is no page of it but named like one; if it is left of an earlier run, delete it"))
        << ending.err;
    EXPECT_EQ(names(), "disc.tif map-2.svg map.svg");
    EXPECT_FALSE(holds(convert({"disc.tif", "-o", "map.pdf"}).err, "no page of it"));
}

TEST_F(Pages, DuplexLeavesTheBackOfADrawingBlank) {
    EXPECT_EQ(convert({"disc.tif", "-o", "map.pdf", "--duplex", "--tiles", "2x1"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "map.pdf"), "/Count 3 "));
    EXPECT_EQ(convert({"disc.tif", "-o", "map.svg", "--duplex", "--label", kLabel}).code, 0);
    EXPECT_EQ(names(), "disc.tif map-2.svg map.pdf map.svg") << "a blank side has no file of its own";
    EXPECT_TRUE(holds(bytes_of(folder / "map.svg"), "On it is the key"));
    EXPECT_TRUE(holds(bytes_of(folder / "map-2.svg"), "<path"));
}

// The machine is told so, the file says so, and a back without anything is a page.
TEST_F(Pages, DuplexTellsMachinesAndPef) {
    EXPECT_EQ(convert({"disc.tif", "-o", "braillo:page.prn", "-o", "page.pef", "-o", "page.brf", "--duplex"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "page.prn"),
                      "\x1b"
                      "C1\x1b"
                      "J0"));
    EXPECT_TRUE(holds(bytes_of(folder / "page.prn"), "\f\r\n\f")) << "the back";
    EXPECT_TRUE(holds(bytes_of(folder / "page.pef"), " duplex=\"true\""));
    EXPECT_EQ(convert({"disc.tif", "-o", "braillo:page.prn", "-o", "page.pef"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "page.prn"),
                      "\x1b"
                      "C0\x1b"
                      "J0"));
    EXPECT_TRUE(holds(bytes_of(folder / "page.pef"), " duplex=\"false\""));
}

TEST_F(Pages, APlanInMillimetresNeedsNoRealWidth) {
    const std::string plan =
        "<svg xmlns='http://www.w3.org/2000/svg' width='400mm' height='300mm' viewBox='0 0 400 300'>"
        "<path d='M0 0h400v300h-400z' fill='none' stroke='#000' stroke-width='3'/></svg>";
    std::ofstream(folder / "plan.svg") << plan;
    EXPECT_EQ(convert({"plan.svg", "-o", "page.svg", "--scale", "1:4"}).code, 0);
    EXPECT_TRUE(holds(bytes_of(folder / "page.svg"), "l100"));
    std::ofstream(folder / "unsized.svg") << tests::without(plan, "width='400mm' height='300mm'");
    EXPECT_TRUE(holds(convert({"unsized.svg", "-o", "page.svg", "--scale", "1:4"}).err, "add for example --real-width 12m"));
}

TEST_F(Pages, ScaleIsRead) {
    const auto fault = [&](const Words& more) {
        Words words{"disc.tif", "-o", "page.svg"};
        words.insert(words.end(), more.begin(), more.end());
        const Ending ending = convert(words);
        EXPECT_NE(ending.code, 0);
        return ending.err;
    };
    EXPECT_EQ(convert({"disc.tif", "-o", "a.svg", "--real-width", "12m", "--scale", "1:100"}).code, 0);
    EXPECT_EQ(convert({"disc.tif", "-o", "b.svg", "--real-width", "1200cm", "--scale", "1cm=1m"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "a.svg"), bytes_of(folder / "b.svg"));
    EXPECT_TRUE(holds(bytes_of(folder / "a.svg"), "tactics-scale"));
    EXPECT_TRUE(holds(bytes_of(folder / "a.svg"), "stands for 5 m: 1 cm on the page is 1 m."));
    EXPECT_TRUE(holds(run_tactics(folder, {"describe", "disc.tif", "--real-width", "12m"}).out, "The scale bar in the "));
    for (const std::string wrong : {"1:0", "1:-5", "100", "1cm=", "=1m", "1:x", "", "1cm=0m", "1:1e99"})
        EXPECT_TRUE(holds(fault({"--real-width", "12m", "--scale", wrong}),
                          "tactics: --scale: it cannot be \"" + wrong + "\"; it is a ratio such as 1:100"))
            << wrong;
    EXPECT_TRUE(holds(fault({"--scale", "1:100"}),
                      "--scale: a picture does not tell how large it is in the world; add for example --real-width 12m"));
    EXPECT_TRUE(holds(fault({"--scale", "1:100", "--real-width", "12m", "--width", "10cm"}), "leave out --width or --scale"));
    EXPECT_TRUE(
        holds(fault({"--scale", "1:10", "--real-width", "12m"}), "--scale: at this scale the drawing would be 1200 mm wide"));
    EXPECT_TRUE(holds(fault({"--real-width", "12m", "--bare"}), "--bare: the drawing alone has no scale bar"));
    EXPECT_TRUE(holds(fault({"--caption", "x", "--bare"}), "--bare: the drawing alone has no caption"));
}

// Paper for hardly a cell: every request is carried out, or refused with an alternative.
TEST_F(Pages, PaperSmallerThanACellIsTold) {
    int done = 0, refused = 0;
    for (const std::string paper : {"5x5mm", "10x10mm", "12x12mm", "20x20mm", "40x15mm"})
        for (const std::string margin : {"", "0mm"})
            for (const Words& more :
                 {Words{}, Words{"--title", "Cat"}, Words{"--caption", "Cat"}, Words{"--label", "50%,50%=Cat"},
                  Words{"--real-width", "3m"}, Words{"--tiles", "2x2"}, Words{"--duplex", "--label", kLabel}}) {
                Words words{"disc.tif", "-q", "-o", "page.svg", "-o", "page.brf", "--paper", paper};
                if (!margin.empty()) words.insert(words.end(), {"--margin", margin});
                words.insert(words.end(), more.begin(), more.end());
                const Ending ending = convert(words);
                (ending.code == 0 ? done : refused) += 1;
                if (ending.code == 0) continue;
                EXPECT_EQ(ending.code, 1) << ending.err;
                EXPECT_TRUE(holds(ending.err, "; ")) << ending.err;
                EXPECT_TRUE(holds(ending.err, "larger paper") || holds(ending.err, "take paper") ||
                            holds(ending.err, "10 to 5080 mm"))
                    << ending.err;
            }
    EXPECT_GT(done, 3);
    EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace tactics::tests::pages_test
