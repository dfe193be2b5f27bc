// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study matching` as the user meets it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/patterns.h"
#include "tests/studies/evaluating.h"

namespace tactics::matching_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
// A black square in one corner of a square picture.
std::string corner(int left, int top) {
    return png(200, 200, [=](int x, int y) { return x >= left && x < left + 90 && y >= top && y < top + 90; });
}

class EvaluateMatching : public testing::Test {
protected:
    EvaluateMatching() {
        fs::create_directories(folder / "set");
        write_bytes(folder / "set/a.png", corner(5, 5));
        write_bytes(folder / "set/b.png", corner(105, 5));
        write_bytes(folder / "set/c.png", corner(5, 105));
        write_bytes(folder / "set/d.png", corner(105, 105));
    }

    Ending study(Words words) {
        words.insert(words.begin(), {"evaluate", "set", "--study", "matching", "-q"});
        return run_tactics(folder, words);
    }

    Folder folder;
};

TEST_F(EvaluateMatching, SaysWhatItIsAndHowThePaperFares) {
    const Ending ending = study({});
    EXPECT_EQ(ending.code, 0) << ending.err;
    for (const std::string name : {"none", "kmeans", "sobel", "kmeans-sobel", "sobel-kmeans", "photo", "auto"})
        EXPECT_TRUE(holds(ending.out, "\n" + name + " ")) << name << "\n" << ending.out;
    for (const std::string said : {"A simulation, not a study with people", "has not been checked on people", "one set of 4",
                                   "by chance 0.250", "The paper's order (none, then kmeans and sobel,", "Under 60 readers"})
        EXPECT_TRUE(holds(ending.out, said)) << said << "\n" << ending.out;
    EXPECT_FALSE(holds(ending.out, "user study"));
    // Without the paper's five there is no order to speak of.
    EXPECT_FALSE(holds(study({"-r", "sobel"}).out, "The paper's order"));
}

TEST_F(EvaluateMatching, FourSquaresInFourCornersAreToldApartAndFourAlikeAreNot) {
    const std::string apart = study(cut_and({"--json"})).out;
    EXPECT_TRUE(holds(apart, R"("recipe":"threshold method=fixed","matched":1,)")) << apart;
    const tests::Fit ink = tests::first_fit(apart, R"("ink":(0\.[0-9]+))");
    ASSERT_FALSE(ink.empty()) << apart;
    EXPECT_NEAR(std::stod(ink[1]), 90.0 * 90 / (200 * 200), 0.002);
    for (const char name : std::string("bcd")) write_bytes(folder / (std::string("set/") + name + ".png"), corner(5, 5));
    const std::string alike = study(cut_and({"--json"})).out;
    const tests::Fit matched = tests::first_fit(alike, R"("matched":(0\.[0-9]+))");
    ASSERT_FALSE(matched.empty()) << alike;
    EXPECT_NEAR(std::stod(matched[1]), 0.25, 0.12);
}

TEST_F(EvaluateMatching, TheSameSeedGivesTheSameWithAnyNumberOfWorkers) {
    const auto out = [&](Words words) { return study(cut_and(std::move(words))).out; };
    for (const char name : std::string("bc"))
        write_bytes(folder / (std::string("set/") + name + ".png"), corner(5, 5));  // by luck
    const std::string alone = out({"--json", "--jobs", "1"});
    EXPECT_EQ(alone, out({"--json", "--jobs", "4"}));
    EXPECT_EQ(alone, out({"--json", "--seed", "1"}));
    EXPECT_NE(out({"--csv", "-"}), out({"--csv", "-", "--seed", "2"}));  // the usual reader's answers
    const auto random_readers = [](const std::string& json) { return json.substr(json.find("\"random_readers\"")); };
    EXPECT_NE(random_readers(alone), random_readers(out({"--json", "--seed", "2"})));
}

// The middle of a picture is what is felt, so that its shape tells nothing.
TEST_F(EvaluateMatching, PicturesAreCutToTheirMiddleSquare) {
    write_bytes(folder / "set/b.png",
                png(400, 200, [](int x, int y) { return x < 100 || (x >= 105 && x < 195 && y >= 5 && y < 95); }));
    write_bytes(folder / "set/c.png",
                png(200, 400, [](int x, int y) { return y < 100 || (x >= 5 && x < 95 && y >= 105 && y < 195); }));
    const std::string csv = study(cut_and({"--csv", "-"})).out;
    std::vector<std::string> inks;
    for (const tests::Fit& line : tests::all_fits(csv, "threshold method=fixed,[abc],[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,([^,]*),"))
        inks.push_back(line[1]);
    ASSERT_EQ(inks.size(), 3u) << csv;
    EXPECT_EQ(inks[0], inks[1]) << csv;
    EXPECT_EQ(inks[0], inks[2]) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
}

TEST_F(EvaluateMatching, RecallStandsBesideIfThereAreContourMaps) {
    EXPECT_FALSE(holds(study({"-r", "sobel", "--json"}).out, "recall"));
    fs::create_directories(folder / "set/gt");
    // In the middle of a wide picture a person drew the border of the black square, and a line that no recipe draws. Lines at its
    // left and right are not on the sheet.
    write_bytes(folder / "set/a.png", png(300, 200, [](int x, int y) { return x >= 55 && x < 145 && y >= 5 && y < 95; }));
    write_bytes(folder / "set/gt/a_gt1.png", png(300, 200, [](int x, int y) {
                    const bool seen = (x == 145 && y >= 5 && y < 95) || (y == 150 && x >= 50 && x < 250) || x < 20 || x > 290;
                    return !seen;
                }));
    const std::string json = study({"-r", "sobel", "--json"}).out;
    const tests::Fit recall = tests::first_fit(json, R"("recall":(0\.[0-9]+))");
    ASSERT_FALSE(recall.empty()) << json;
    EXPECT_NEAR(std::stod(recall[1]), 90.0 / 290, 0.06);
}

TEST_F(EvaluateMatching, NamesWhatItCannotUseAndGoesOn) {
    write_bytes(folder / "set/e.png", corner(5, 5).substr(0, 80));
    write_bytes(folder / "set/notes.txt", "hello");
    const Ending ending = study(kCut);
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "set/e.png: ") && holds(ending.err, "set/notes.txt: ")) << ending.err;
    EXPECT_TRUE(holds(ending.err, "2 could not be used:")) << ending.err;
    EXPECT_TRUE(holds(ending.out, "one set of 4")) << ending.out;
    for (const std::string name : {"b", "c", "d"}) fs::remove(folder / ("set/" + name + ".png"));
    const Ending alone = study(kCut);
    EXPECT_EQ(alone.code, 2);
    EXPECT_TRUE(holds(alone.err, "at least 2 pictures that can be read are needed; here is one")) << alone.err;
}

TEST_F(EvaluateMatching, LargeFoldersAreDividedIntoSets) {
    for (int i = 0; i < 17; ++i) write_bytes(folder / ("set/x" + std::to_string(i) + ".png"), corner(6 * i, 5));
    const Ending ending = study(kCut);
    EXPECT_TRUE(holds(ending.out, "2 sets of 10 to 11; by chance 0.095")) << ending.out;
}

TEST_F(EvaluateMatching, ASheetIsOfTheWholeMiddle) {
    const Ending ending = study({"-q", "-f", "crop left=10", "-f", "threshold method=fixed level=128"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "leave out crop")) << ending.err;
}

TEST_F(EvaluateMatching, WhatMakesNoSenseIsRefused) {
    for (const Words& wrong : {Words{"--paper", "a4"}, Words{"--margin", "5mm"}, Words{"--sweep", "threshold.level=1,2"},
                               Words{"--seed", "1.5"}, Words{"--seed", "-1"}, Words{"--json", "--csv", "-"}})
        EXPECT_EQ(study(cut_and(wrong)).code, 1) << wrong[0];
    EXPECT_EQ(run_tactics(folder, {"evaluate", "set", "--study", "machting"}).code, 1);
    EXPECT_TRUE(holds(run_tactics(folder, {"evaluate", "set", "--study", "machting"}).err, "matching"));
    fs::create_directories(folder / "set/gt");
    EXPECT_EQ(run_tactics(folder, {"evaluate", "set", "--seed", "2"}).code, 1);
}

}  // namespace
}  // namespace tactics::matching_test
