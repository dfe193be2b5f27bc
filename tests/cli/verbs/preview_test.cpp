// SPDX-License-Identifier: Apache-2.0
// `tactics preview`, and embossers as convert writes for them: the real program, real files.
#include "tests/cli/converting.h"

namespace tactics::preview_test {
namespace {

using namespace tests;

class Preview : public Convert {
protected:
    Ending preview(Words words) {
        words.insert(words.begin(), "preview");
        return run_tactics(folder, words);
    }
};

TEST_F(Preview, ShowsWhatConvertWroteForAnEmbosser) {
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "index-v4:disc.prn", "--title", "A disc"}).code, 0);
    const Ending told = preview({"disc.prn", "--embosser", "index-v4"});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_EQ(told.err, "");
    EXPECT_TRUE(told.out.starts_with("sheet 1: ")) << told.out;
    EXPECT_TRUE(holds(told.out, " dots, from ")) << told.out;
    const Ending drawn = preview({"disc.prn", "-e", "index-v4", "-o", "disc.svg", "-o", "disc.png"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(names(), "disc.png disc.prn disc.svg disc.tif");
    const Ending unicode = preview({"disc.prn", "-e", "index-v4", "--unicode"});
    EXPECT_TRUE(holds(unicode.out, "\xE2\xA1")) << unicode.out;
    EXPECT_FALSE(holds(unicode.out, "sheet"));
}

TEST_F(Preview, TellsEveryDotInJson) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "braillo:disc.prn"}).code, 0);
    write_bytes(folder / "count.py",
                "import sys, json\n"
                "for line in sys.stdin:\n"
                "    sheet = json.loads(line)\n"
                "    print(sheet['sheet'], sheet['width_mm'], len(sheet['dots']) > 20, sheet['notes'])\n");
    const Ending json = preview({"disc.prn", "-e", "braillo", "--json"});
    EXPECT_EQ(run_tool(folder, {"python3", "count.py"}, json.out).out, "1 210 True []\n");
}

TEST_F(Preview, SaysWhatTheMachineWouldNotUnderstand) {
    write_bytes(folder / "odd.prn", "\x1b\x07\x41!\x1b\x06\x1bZ\f");
    const Ending ending = preview({"odd.prn", "-e", "index-v4"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.out, "sheet 1: 1 dot, from 5.8 to 5.8 mm across and from 5.8 to 5.8 mm down\n");
    EXPECT_EQ(ending.err,
              "odd.prn: byte 3: a byte that is no column of graphics\n"
              "odd.prn: byte 6: an ESC command that is not known here\n");
}

TEST_F(Preview, BearsWhatIsTooMuchAndTooFar) {
    write_bytes(folder / "far.prn",
                "\x1b"
                "F;\n1e308:1\nnan:2\n5:6;\f");
    const Ending far = preview({"far.prn", "-e", "index-v4-floating", "--json"});
    EXPECT_TRUE(holds(far.out, "\"dots\":[[5,6]]")) << far.out;
    EXPECT_TRUE(holds(far.err, "byte 4: a floating dot is x:y, in mm")) << far.err;
    write_bytes(folder / "feeds.prn", std::string(300'000, '\f'));
    EXPECT_TRUE(holds(preview({"feeds.prn", "-e", "generic"}).err, "there are over 100000 sheets"));
}

TEST_F(Preview, OfAFlawedJobOnlySomeSheetsAreDrawn) {
    std::string sheets;
    for (int sheet = 0; sheet < 1500; ++sheet) sheets += "A\f";
    write_bytes(folder / "noise.prn", sheets);
    const Ending told = preview({"noise.prn", "-e", "generic", "-o", "noise.pdf"});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.err, "pictures show the first 1000 of 1500 sheets; cut the file up to see the others")) << told.err;
    EXPECT_TRUE(holds(told.out, "sheet 1500: 1 dot")) << told.out;
    const std::string pages = bytes_of(folder / "noise.pdf");
    EXPECT_TRUE(holds(pages, "/Count 1000"));
    write_bytes(folder / "noise.prn", sheets.substr(0, 2000));
    EXPECT_EQ(preview({"noise.prn", "-e", "generic", "-o", "noise.pdf"}).err, "");
    // One sheet, too, can be too much: a thousand lines over each other.
    std::string over;
    for (int line = 0; line < 1000; ++line) over += std::string(100, '=') + "\r";
    write_bytes(folder / "noise.prn", over);
    const Ending one = preview({"noise.prn", "-e", "generic", "-o", "noise.svg"});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_TRUE(holds(one.err, "pictures show the first 500000 of 600000 dots")) << one.err;
}

TEST_F(Preview, NeedsAMachineThatItKnows) {
    write_bytes(folder / "a.prn", "A\f");
    EXPECT_EQ(preview({"a.prn"}).code, 1);
    EXPECT_TRUE(
        holds(preview({"a.prn", "-e", "index-v5"}).err, "there is no embosser and no display of pins \"index-v5\" (index-v"));
    EXPECT_TRUE(holds(preview({"a.prn", "-e", "nothing"}).err, "; see tactics list embossers and tactics list displays"));
    EXPECT_TRUE(holds(preview({"a.prn"}).err,
                      "name the machine that the bytes are for; see tactics list embossers and tactics list displays"));
    EXPECT_EQ(preview({"a.prn", "-e", "pdf"}).code, 1);
    EXPECT_EQ(preview({"a.prn", "-e", "generic", "--set", "generic.dots=7"}).code, 1);
    EXPECT_EQ(preview({"a.prn", "-e", "generic", "--set", "index-v4.pitch=2.0"}).code, 1);
    EXPECT_EQ(preview({"a.prn", "-e", "generic", "-o", "index-v4:b.prn"}).code, 1);
    EXPECT_EQ(preview({"missing.prn", "-e", "generic"}).code, 2);
    EXPECT_EQ(names(), "a.prn disc.tif");
}

TEST_F(Preview, ADisplayHasNoPaper) {
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "dot-pad:disc.bin"}).code, 0);
    EXPECT_EQ(preview({"disc.bin", "-e", "dot-pad"}).code, 0);
    for (const Words& words : {Words{"--paper", "a4"}, {"--orientation", "landscape"}}) {
        const Ending ending = preview({"disc.bin", "-e", "dot-pad", words[0], words[1]});
        EXPECT_EQ(ending.code, 1);
        EXPECT_TRUE(
            holds(ending.err, words[0] + ": dot-pad is a display, all of which is shown, so this would do nothing; leave it out"))
            << ending.err;
    }
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "index-v4:disc.prn"}).code, 0);
    EXPECT_EQ(preview({"disc.prn", "-e", "index-v4", "--paper", "a4", "--orientation", "portrait"}).code, 0);
    // Printing goes to embossers only.
    const Ending printed = run_tactics(folder, {"emboss", "disc.bin", "--to", "out.prn", "-e", "dot-pad"}),
                 made = run_tactics(folder, {"ppd", "dot-pad"});
    EXPECT_EQ(printed.code, 1);
    EXPECT_EQ(made.code, 1);
    EXPECT_TRUE(
        holds(printed.err,
              "--embosser: dot-pad is a display, which no paper goes through; use tactics show FILE --on dot-pad:/dev/ttyUSB0"))
        << printed.err;
    EXPECT_TRUE(holds(made.err,
                      "ppd: dot-pad is a display, which no paper goes through; use tactics show FILE --on dot-pad:/dev/ttyUSB0"))
        << made.err;
    const Ending near = run_tactics(folder, {"ppd", "dot-pat"});
    EXPECT_TRUE(holds(near.err, "there is no embosser \"dot-pat\"; see tactics list embossers")) << near.err;
}

TEST_F(Preview, OfASheetThatTheMachineDoesNotTakeNothingIsWritten) {
    const Ending large = convert({"disc.tif", "-o", "index-v4:disc.prn", "--paper", "400x700mm"});
    EXPECT_EQ(large.code, 1);
    EXPECT_TRUE(holds(large.err, " mm wide, and this machine takes 325 mm; choose a smaller --paper")) << large.err;
    const Ending bare = convert({"disc.tif", "-o", "index-v4:disc.prn", "--bare"});
    EXPECT_TRUE(holds(bare.err, "--bare: an embosser raises dots on a sheet with margins")) << bare.err;
    EXPECT_EQ(names(), "disc.tif");
    EXPECT_TRUE(
        holds(convert({"disc.tif", "-o", "viewplus:disc.png", "--duplex"}).err, "--duplex: viewplus is made for one side"));
    EXPECT_TRUE(
        holds(convert({"disc.tif", "-o", "pef:disc.pef", "--cell", "nls"}).err, "--cell: pef has braille of its own size"));
    EXPECT_EQ(names(), "disc.tif");
    // Of a large page each sheet has to go in.
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "index-v4:tiles.prn", "--tiles", "2x1"}).code, 0);
    EXPECT_TRUE(holds(preview({"tiles.prn", "-e", "index-v4"}).out, "sheet 2: "));
    // One that takes it upright only has it upright.
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "braillo:disc.prn"}).code, 0);
}

TEST_F(Preview, TheHelpOfAnEmbosserSaysHowSureItsBytesAre) {
    const Ending help = run_tactics(folder, {"help", "index-v4-floating"});
    EXPECT_EQ(help.code, 0);
    EXPECT_TRUE(holds(help.out, "uncertain: ESC F")) << help.out;
    EXPECT_TRUE(holds(help.out, "Example: tactics convert photo.jpg -o index-v4-floating:page.prn")) << help.out;
    EXPECT_TRUE(holds(run_tactics(folder, {"list", "embossers"}).out, "viewplus: ViewPlus"));
}

}  // namespace
}  // namespace tactics::preview_test
