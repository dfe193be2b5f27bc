// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate` as the user meets it: the real program on a folder whose scores are known.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/patterns.h"
#include "tests/studies/evaluating.h"

namespace tactics::contours_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
constexpr int kWidth = 400, kHeight = 300;

// A contour map with one vertical line.
std::string column(int at, int from = 0, int to = kHeight) {
    return png(kWidth, kHeight, [=](int x, int y) { return !(x == at && y >= from && y < to); });
}

std::string half_black() {
    return png(kWidth, kHeight, [](int x, int) { return x < 200; });
}

class Evaluate : public testing::Test {
protected:
    Evaluate() {
        fs::create_directories(folder / "set/images");
        fs::create_directories(folder / "set/gt");
        // The border lies at column 199. Of picture a one person drew all of it, another a line that is not there; of picture
        // b somebody drew the upper half.
        write_bytes(folder / "set/images/a.png", half_black());
        write_bytes(folder / "set/images/b.png", half_black());
        write_bytes(folder / "set/gt/a_gt1.png", column(199));
        write_bytes(folder / "set/gt/a_gt2.png", column(100));
        write_bytes(folder / "set/gt/b_gt1.png", column(201, 0, 150));
    }

    Ending evaluate(Words words) {
        words.insert(words.begin(), {"evaluate", "set"});
        return run_tactics(folder, words);
    }

    Folder folder;
};

// Times and memory are the run's, all else is the picture's.
std::string without_times(const std::string& json) {
    return tests::without(json, R"re("(recipe_ms|whole_ms|peak_memory_mib)":[-0-9.e]+)re");
}

TEST_F(Evaluate, GivesTheScoresThatAreKnown) {
    // 450 of 600 line pixels are right, and 450 of 750 people's pixels are found.
    const Ending table = evaluate(kCut);
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(table.out.starts_with("recipe ")) << table.out;
    EXPECT_TRUE(holds(table.out, "threshold method=fixed  0.667  0.750  0.600  0.667 ")) << table.out;
    // For picture a the two people agree in nothing; for b there is no second person.
    EXPECT_TRUE(holds(table.out, "\npeople                  0.000  0.000  0.000 ")) << table.out;
    EXPECT_TRUE(holds(table.err, "2 pictures with 3 contour maps")) << table.err;
    EXPECT_EQ(evaluate(cut_and({"--quiet"})).err, "");

    const Ending json = evaluate(cut_and({"--json", "-q"}));
    EXPECT_TRUE(holds(json.out, R"("picture":"a","f":0.666667,"precision":1,"recall":0.5,)")) << json.out;
    EXPECT_TRUE(holds(json.out, R"("picture":"b","f":0.666667,"precision":0.5,"recall":1,)")) << json.out;
    EXPECT_TRUE(holds(json.out, R"("problems":[])")) << json.out;
}

TEST_F(Evaluate, WritesTheSameTableForASpreadsheet) {
    const Ending ending = evaluate(cut_and({"--csv", "table.csv", "-q"}));
    EXPECT_EQ(ending.code, 0) << ending.err;
    const std::string csv = bytes_of(folder / "table.csv");
    EXPECT_TRUE(csv.starts_with("recipe,f,precision,recall,ois_f,")) << csv;
    EXPECT_TRUE(holds(csv, "\r\nthreshold method=fixed,0.667,0.750,0.600,0.667,,,,")) << csv;
    EXPECT_TRUE(holds(csv, "\r\npeople,0.000,")) << csv;
    EXPECT_TRUE(evaluate(cut_and({"--csv", "-", "-q"})).out.starts_with("recipe,f,"));
    EXPECT_EQ(evaluate(cut_and({"--csv", "-", "--json"})).code, 1);
}

TEST_F(Evaluate, EveryRecipeAndAutoUnlessSomeAreNamed) {
    const Ending all = evaluate({"-q"});
    EXPECT_EQ(all.code, 0) << all.err;
    for (const std::string name : {"none", "kmeans", "sobel-kmeans", "photo", "line-art", "auto", "people"})
        EXPECT_TRUE(holds("\n" + all.out, "\n" + name + " ")) << name << "\n" << all.out;
    const Ending two = evaluate({"-q", "-r", "sobel", "-r", "auto"});
    EXPECT_EQ(std::count(two.out.begin(), two.out.end(), '\n'), 5) << two.out;
    // --detail turns the recipes that have a dial; one that is named must have it.
    EXPECT_EQ(evaluate({"-q", "--detail", "contours"}).code, 0);
    EXPECT_EQ(evaluate({"-q", "-r", "sobel", "--detail", "contours"}).code, 1);
}

TEST_F(Evaluate, AnySharingOfTheWorkGivesTheSame) {
    for (const char name : std::string("cdefgh")) {
        write_bytes(folder / (std::string("set/images/") + name + ".png"), half_black());
        write_bytes(folder / (std::string("set/gt/") + name + "_gt1.png"), column(190 + name % 13));
    }
    write_bytes(folder / "set/images/x.png", "no picture");
    write_bytes(folder / "set/gt/x_gt1.png", column(3));
    const Words words{"-q", "--json", "-r", "photo", "-r", "sobel", "-r", "auto"};
    Words one = words, four = words;
    one.insert(one.end(), {"--jobs", "1"});
    four.insert(four.end(), {"--jobs", "4"});
    const std::string alone = without_times(evaluate(one).out);
    EXPECT_TRUE(holds(alone, "\"x\",\"error\"")) << alone;
    EXPECT_EQ(alone, without_times(evaluate(four).out));
}

TEST_F(Evaluate, SweepsAndHalves) {
    const Ending ending = evaluate({"-q", "-f", "threshold method=fixed", "--sweep", "threshold.level=0,128,255"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.out, " 0.667  0.750  0.600 ")) << ending.out;
    EXPECT_TRUE(holds(ending.out, "  threshold.level=128\n")) << ending.out;
    // Counted from 1: a is odd, b is even.
    EXPECT_TRUE(holds(evaluate(cut_and({"-q", "--half", "odd"})).out, "  0.667  1.000  0.500 "));
    EXPECT_TRUE(holds(evaluate(cut_and({"-q", "--half", "even"})).out, "  0.667  0.500  1.000 "));
    for (const Words& wrong : {Words{"--half", "third"}, Words{"--sweep", "kmeans"}, Words{"--sweep", "kmeans.k=2,x"},
                               Words{"--sweep", "kmeans.k="}, Words{"--sweep", "png.dpi=2"}, Words{"--sweep", "sobel.blur=1,2"}})
        EXPECT_EQ(evaluate(cut_and(wrong)).code, 1) << wrong[1];
}

// Everything that cannot be scored is named, and the rest is scored as without it.
TEST_F(Evaluate, NamesWhatItCannotScore) {
    const std::string rows = without_times(evaluate(cut_and({"-q"})).out);
    write_bytes(folder / "set/images/bare.png", half_black());
    write_bytes(folder / "set/gt/orphan_gt1.png", column(1));
    write_bytes(folder / "set/gt/notes.txt", "hello");
    write_bytes(folder / "set/images/small.png", half_black());
    write_bytes(folder / "set/gt/small_gt1.png", png(40, 30, [](int x, int) { return x != 3; }));
    write_bytes(folder / "set/images/readme.txt", "once");  // neither picture nor map of it
    write_bytes(folder / "set/images/text.jpg", "this is no picture");
    write_bytes(folder / "set/gt/text_gt1.png", column(1));
    write_bytes(folder / "set/images/cut.png", half_black().substr(0, 150));
    write_bytes(folder / "set/gt/cut_gt1.png", column(1));
    write_bytes(folder / "set/images/negative.png", half_black());
    write_bytes(folder / "set/gt/negative_gt1.png", png(kWidth, kHeight, [](int x, int) { return x == 199; }));
    const Ending ending = evaluate(cut_and({"-q"}));
    EXPECT_EQ(ending.code, 2);
    for (const std::string named : {"images/bare.png: ", "gt/orphan_gt1.png: ", "gt/notes.txt: ", "gt/small_gt1.png: ",
                                    "images/text.jpg: ", "images/readme.txt: ", "images/cut.png: ", "gt/negative_gt1.png: "})
        EXPECT_TRUE(holds(ending.err, named)) << named << "\n" << ending.err;
    EXPECT_TRUE(holds(ending.err, "8 could not be scored:")) << ending.err;
    EXPECT_TRUE(holds(ending.out, " 0.667  0.750  0.600  0.667 ")) << ending.out;
    EXPECT_FALSE(tests::first_fit(ending.out, "method=fixed.* 2 +6 +0\n").empty()) << ending.out;
}

TEST_F(Evaluate, AFolderWithoutPicturesOrTruthIsTold) {
    fs::create_directories(folder / "hollow/gt");
    EXPECT_EQ(run_tactics(folder, {"evaluate", "hollow"}).code, 2);
    EXPECT_TRUE(holds(run_tactics(folder, {"evaluate", "hollow"}).err, "hollow: there is no picture in this folder"));
    EXPECT_TRUE(holds(run_tactics(folder, {"evaluate", "nowhere"}).err, "there is no such folder"));
    EXPECT_EQ(run_tactics(folder, {"evaluate"}).code, 1);
    // Pictures in the folder itself, maps elsewhere.
    const Ending ending = run_tactics(folder, {"evaluate", "set/images", "--truth", "set/gt", "-q", kCut[0], kCut[1]});
    EXPECT_TRUE(holds(ending.out, "  0.667  0.750  0.600 ")) << ending.err;
}

TEST_F(Evaluate, ARecipeThatDrawsNothingIsScoredAndNamed) {
    write_bytes(folder / "set/images/b.png", png(kWidth, kHeight, [](int, int) { return false; }));
    const Ending ending = evaluate(kCut);
    EXPECT_EQ(ending.code, 0);
    EXPECT_TRUE(holds(ending.err, "recipe threshold method=fixed draws nothing on 1 picture: b\n")) << ending.err;
    EXPECT_FALSE(tests::first_fit(ending.out, "method=fixed +0\\.571 +1\\.000 +0\\.400 .* 2 +0 +1\n").empty()) << ending.out;
}

TEST_F(Evaluate, ATableThatCannotBeWrittenIsToldBeforeTheWork) {
    for (const Words& wrong :
         {Words{"--csv", "nowhere/t.csv"}, Words{"--csv", "set"}, Words{"--csv", "t.pdf", "--chart", "./t.pdf"}}) {
        Words words = wrong;
        words.insert(words.end(), kCut.begin(), kCut.end());
        const Ending ending = evaluate(words);
        EXPECT_EQ(ending.code, 1) << wrong[1];
        EXPECT_EQ(ending.out, "") << wrong[1];
        EXPECT_TRUE(holds(ending.err, "--csv: ")) << ending.err;
    }
    EXPECT_FALSE(fs::exists(folder / "t.pdf"));
}

TEST_F(Evaluate, ASettingOfAFormatIsRefused) {
    EXPECT_EQ(
        evaluate(cut_and({"--set", "png.dpi=300"})).err,
        "tactics: --set 1: png is a format, and --set does not reach formats here; leave it out, or use --dpi for a chart\n");
}

TEST_F(Evaluate, APartOfThePictureIsNotScored) {
    const Ending ending = evaluate({"-q", "-f", "crop left=10", "-f", "threshold method=fixed level=128", "-r", "sobel"});
    EXPECT_EQ(ending.code, 1);  // sobel gives a drawing, which cannot be cropped
    const Ending cropped = evaluate({"-q", "-f", "crop left=10", "-f", "threshold method=fixed level=128"});
    EXPECT_EQ(cropped.code, 2);
    EXPECT_TRUE(holds(cropped.err, "set/images/a.png: only a part of the picture is left")) << cropped.err;
    EXPECT_TRUE(holds(cropped.err, "2 could not be scored:")) << cropped.err;
}

}  // namespace
}  // namespace tactics::contours_test
