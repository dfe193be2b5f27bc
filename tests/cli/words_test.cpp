// SPDX-License-Identifier: Apache-2.0
// Words in pictures and figures, as the user meets them.
#include "tactics/job/print_words.h"
#include "tactics/job/scale_numbers.h"
#include "tests/cli/converting.h"

namespace tactics::words_test {
namespace {

using namespace tests;

constexpr const char* kFigure =
    "<svg xmlns='http://www.w3.org/2000/svg' width='160mm' height='120mm' viewBox='0 0 160 120'><title>Rain in Bremen</title>"
    "<g stroke='black' fill='none'><path d='M30 10 V100 H150' stroke-width='0.4'/><path d='M30 90 L80 40 L150 60' "
    "stroke-width='0.8'/></g>"
    "<g font-size='5'><text x='20' y='102' text-anchor='end'>0</text><text x='20' y='62' text-anchor='end'>50</text>"
    "<text x='20' y='22' text-anchor='end'>100</text><text transform='translate(8 70) rotate(-90)'>mm</text>"
    "<text x='90' y='112' text-anchor='middle'>Month</text></g></svg>";

class PictureWords : public Convert {
protected:
    // A tesseract that reads every strip as that, or ends in its own way, where no font is installed to say otherwise.
    Ending with_reader(const std::string& script, tests::Words words) {
        write_bytes(folder / "tesseract", "#!/bin/sh\n" + script);
        write_bytes(folder / "fonts.conf",
                    "<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig></fontconfig>");
        std::filesystem::permissions(folder / "tesseract", std::filesystem::perms::owner_all);
        words.insert(words.begin(), {"env", "FONTCONFIG_FILE=" + (folder / "fonts.conf").string(),
                                     "PATH=" + folder.path().string() + ":/usr/bin:/bin", TACTICS_PROGRAM, "convert"});
        return run_tool(folder, words);
    }
    // Two blocks like letters in the middle of a white field.
    void draw_lettering() {
        std::string picture = "P5\n200 100\n255\n" + std::string(20'000, '\xff');
        for (const std::size_t left : {90u, 101u})
            for (std::size_t y = 44; y < 56; ++y)
                for (std::size_t x = left; x < left + 8; ++x)
                    if (x < left + 3 || y > 52) picture[15 + 200 * y + x] = 0;
        write_bytes(folder / "chart.pgm", picture);
    }
    static std::string table(const std::string& sureness) {
        return "for page in 1 2; do printf \"5\\t$page\\t1\\t1\\t1\\t1\\t0\\t0\\t9\\t9\\t" + sureness + "\\tLL\\n\"; done\n";
    }
};

TEST_F(PictureWords, OfAFigureStandInBraille) {
    write_bytes(folder / "rain.svg", kFigure);
    const Ending end = convert({"rain.svg", "-o", "page.svg", "--json", "-r", "photo"});
    ASSERT_EQ(end.code, 0) << end.err;
    EXPECT_TRUE(holds(end.out, "\"format\":\"SVG\",\"width\":160,\"height\":120"));
    for (const std::string text : {"0", "50", "100", "mm", "Month"})
        EXPECT_TRUE(holds(end.out, "{\"text\":\"" + text + "\",\"sureness\":100,\"set\":true")) << text;
    EXPECT_TRUE(holds(end.out, "it is lines already, so --recipe, --filter, --detail and settings of filters do nothing to it"));
    EXPECT_TRUE(holds(bytes_of(folder / "page.svg"), "<title id=\"title\">Rain in Bremen</title>"));
    const Ending check = run_tactics(folder, {"check", "page.svg", "--rule", "braille-clearance", "--strict"});
    EXPECT_EQ(check.code, 0) << check.out;
    EXPECT_TRUE(holds(convert({"rain.svg", "-o", "page.svg", "--words", "leave"}).err, "rain.svg: its words are left out"));
}

TEST_F(PictureWords, FiguresAndPicturesMakeOneBatch) {
    write_bytes(folder / "rain.svg", kFigure);
    write_bytes(folder / "bad.svg", "<svg width='1mm'");
    const Ending end = convert({"rain.svg", "disc.tif", "bad.svg", "-o", "pages/"});
    EXPECT_EQ(end.code, 2);
    EXPECT_TRUE(holds(end.err, "bad.svg:1: this is not well-formed XML")) << end.err;
    EXPECT_EQ(names("pages"), "disc.pdf rain.pdf");
}

TEST_F(PictureWords, ThatAreSureAreSetAndOthersAreTold) {
    draw_lettering();
    const Ending sure = with_reader(table("95"), {"chart.pgm", "-o", "a.svg", "-r", "line-art"});
    EXPECT_EQ(sure.code, 0);
    EXPECT_TRUE(holds(sure.err, "chart.pgm: print was read at 1 place and stands in braille")) << sure.err;
    EXPECT_TRUE(holds(bytes_of(folder / "a.svg"), "<g class=\"tactics-cells-"));
    EXPECT_FALSE(holds(bytes_of(folder / "a.svg"), "stroke-width=\""));
    const Ending unsure = with_reader(table("45"), {"chart.pgm", "-o", "b.svg", "-r", "line-art"});
    EXPECT_TRUE(holds(unsure.err,
                      "chart.pgm: print at 49.8 %, 50 % was read as \"LL\" with little sureness (45 of 100) and is left in the "
                      "lines; if it is words, give it with --label \"49.8%,50%=...\""))
        << unsure.err;
    EXPECT_FALSE(holds(bytes_of(folder / "b.svg"), "<g class=\"tactics-cells-"));
    EXPECT_TRUE(holds(bytes_of(folder / "b.svg"), "stroke-width=\""));
    // What is left in the lines and not drawn is told.
    EXPECT_FALSE(holds(unsure.err, "is too small to be drawn")) << unsure.err;
    const Ending small = with_reader(table("45"), {"chart.pgm", "-o", "b.svg", "-r", "regions"});
    EXPECT_TRUE(holds(small.err, "1 place with print that was not read is too small to be drawn and is not on the page."))
        << small.err;
    // A map or a diagram of areas has its words beside its things, too.
    const Ending regions = with_reader(table("95"), {"chart.pgm", "-o", "d.svg", "-r", "regions"});
    EXPECT_TRUE(holds(regions.err, "chart.pgm: print was read at 1 place and stands in braille")) << regions.err;
    const Ending removed = with_reader(table("45"), {"chart.pgm", "-o", "c.svg", "-r", "line-art", "--words", "remove"});
    // What may be no print stays, and is told.
    EXPECT_TRUE(holds(bytes_of(folder / "c.svg"), "stroke-width=\"")) << removed.err;
    EXPECT_TRUE(holds(removed.err, "chart.pgm: print at 49.8 %, 50 % was read as \"LL\"")) << removed.err;
    const Ending gone = with_reader(table("95"), {"chart.pgm", "-o", "e.svg", "-r", "line-art", "--words", "remove"});
    EXPECT_FALSE(holds(bytes_of(folder / "e.svg"), "stroke-width=\"")) << gone.err;
}

// For many pictures one line summarises them; the full report names each.
TEST_F(PictureWords, UnsureOnesAreALineToActOn) {
    std::string picture = "P5\n200 200\n255\n" + std::string(40'000, '\xff');
    for (const std::size_t left : {90u, 101u})
        for (const std::size_t top : {44u, 144u})
            for (std::size_t y = top; y < top + 12; ++y)
                for (std::size_t x = left; x < left + 8; ++x)
                    if (x < left + 3 || y > top + 8) picture[15 + 200 * y + x] = 0;
    write_bytes(folder / "chart.pgm", picture);
    const std::string pages = "for page in 1 2 3 4; do printf \"5\\t$page\\t1\\t1\\t1\\t1\\t0\\t0\\t9\\t9\\t45\\tLL\\n\"; done\n";
    const Ending all = with_reader(pages, {"chart.pgm", "-o", "a.svg", "-r", "line-art"});
    EXPECT_TRUE(holds(all.err, "print at 49.8 %, 25 % was read as \"LL\"") &&
                holds(all.err, "print at 49.8 %, 75 % was read as \"LL\""))
        << all.err;
    const Ending warned = with_reader(pages, {"chart.pgm", "-o", "a.svg", "-r", "line-art", "--warnings"});
    EXPECT_TRUE(warned.err.starts_with("chart.pgm: print at 2 places was not read for sure and is left in the lines; "))
        << warned.err;
    EXPECT_EQ(lines_in(warned.err), 1u) << warned.err;
}

TEST_F(PictureWords, WithoutAReaderThePictureIsConvertedAsBefore) {
    draw_lettering();
    const Ending before = with_reader("exit 1", {"chart.pgm", "-o", "a.svg", "-r", "line-art", "--words", "leave"});
    const Ending end = with_reader("kill -SEGV $$", {"chart.pgm", "-o", "b.svg", "-r", "line-art"});
    EXPECT_EQ(end.code, 0);
    EXPECT_TRUE(holds(end.err, "chart.pgm: print in it is left in the lines; tesseract failed")) << end.err;
    EXPECT_EQ(bytes_of(folder / "a.svg"), bytes_of(folder / "b.svg"));
    const Ending asked = with_reader("kill -SEGV $$", {"chart.pgm", "-o", "c.svg", "--words", "read"});
    EXPECT_EQ(asked.code, 2);
    EXPECT_TRUE(holds(asked.err, "--words: there is print in the picture; tesseract")) << asked.err;
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "d.pdf", "--words", "raed"}).err, "--words: it cannot be \"raed\" (read?)"));
}

TEST_F(PictureWords, FromRightToLeftAreInBrailleOnly) {
    const std::string title = "\u05e9\u05dc\u05d5\u05dd";
    const Ending end = convert({"disc.tif", "-o", "a.svg", "--title", title, "--braille", "he-IL.utb"});
    if (holds(end.err, "he-IL")) GTEST_SKIP() << end.err;
    EXPECT_EQ(end.code, 0) << end.err;
    EXPECT_TRUE(holds(end.err, "disc.tif: the title runs from right to left and is in braille only")) << end.err;
    const std::string page = bytes_of(folder / "a.svg");
    EXPECT_TRUE(holds(page, "<g class=\"tactics-cells-"));
    EXPECT_FALSE(holds(page, "<text data-tactics-n"));
    EXPECT_TRUE(holds(page, "<title id=\"title\">" + title + "</title>"));
}

TEST(PrintWordsTest, NumbersGoOnlyWhereThatMakesRoom) {
    std::vector<ToldWords> told;
    for (int i = 0; i < 8; ++i) told.push_back({std::to_string(10 * i), 99, 10.0 + 10 * i, 90, true});  // a row
    for (int i = 0; i < 6; ++i) told.push_back({std::to_string(i), 99, 5, 10.0 + 12 * i, true});        // a column
    const auto set_of = [&](std::size_t from, std::size_t to) {
        return static_cast<std::size_t>(std::count_if(told.begin() + static_cast<std::ptrdiff_t>(from),
                                                      told.begin() + static_cast<std::ptrdiff_t>(to),
                                                      [](const ToldWords& one) { return one.set; }));
    };
    const std::vector<ToldWords> all = told;
    std::size_t kept = 0;  // numbers, where the best was found
    const auto thin = [&](const std::function<std::size_t()>& left_out) {
        told = all;
        kept = 0;
        return thin_out_for_room(told, left_out, [&] { kept = set_of(0, 14); });
    };
    EXPECT_EQ(thin([] { return std::size_t{0}; }), 0u);
    EXPECT_EQ(thin([] { return std::size_t{1}; }), 0u) << "a name that has room nowhere";
    EXPECT_EQ(kept, 14u);
    EXPECT_EQ(set_of(0, 14), 14u);
    EXPECT_EQ(thin([&] { return std::size_t{set_of(8, 14) > 3 ? 2u : 0u}; }), 3u) << "the column alone";
    EXPECT_EQ(set_of(0, 8), 8u);
    EXPECT_EQ(kept, 11u);
    EXPECT_EQ(thin([&] { return std::size_t{set_of(0, 8) > 2 ? 3u : 0u}; }), 0u) << "three names, or nine numbers and more";
    EXPECT_EQ(thin([&] { return std::size_t{set_of(0, 8) > 4 ? 1u : 0u}; }), 0u) << "one name, or four numbers";
    EXPECT_EQ(thin([&] { return std::size_t{set_of(0, 8) > 4 ? 2u : 0u}; }), 4u) << "two names";
    EXPECT_EQ(thin([&] { return set_of(0, 8) > 2 ? set_of(0, 8) : 0; }), 4u + 3u + 2u) << "twice";
    EXPECT_EQ(kept, 5u);
}

TEST(PrintWordsTest, EverySecondNumberOfARowOrColumnGoes) {
    std::vector<ToldWords> told;
    for (int i = 0; i < 6; ++i) told.push_back({std::to_string(10 * i), 99, 10.0 + 15 * i, 90.0 + 0.1 * i, true});
    for (int i = 0; i < 3; ++i) told.push_back({std::to_string(i) + ".5", 99, 5, 20.0 + 20 * i, true});
    told.push_back({"Year", 99, 50, 90, true});
    EXPECT_EQ(thin_out(told), 3u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(told[i].set, i % 2 == 0) << i;
    for (std::size_t i = 6; i < told.size(); ++i) EXPECT_TRUE(told[i].set) << i;
    EXPECT_EQ(thin_out(told), 0u);  // three are no row
    for (ToldWords& one : told) one.set = true;
    told[2].text = told[1].text = told[0].text;
    EXPECT_EQ(thin_out(told), 2u);  // of 0, 30, 40 and 50: what comes again is of things
    EXPECT_TRUE(told[0].set && told[1].set && told[2].set);
}

}  // namespace
}  // namespace tactics::words_test
